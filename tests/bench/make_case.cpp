// Writes a ring of N vertices, badly numbered, as mesh.su2 and a case that moves its inner circle by 11
// control points:
//   make_case 1000000 FOLDER
#include "formats/formats.h"
#include "tests/bench/bench_meshes.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>

namespace {

/// A uniform cubic curve over points on a circle of this radius passes through the unit circle at its knots.
double control_radius(int count)
{
    return 6 / (4 + 2 * std::cos(2 * std::numbers::pi / count));
}

void write_case(const std::string& path)
{
    constexpr int kCount = 11;
    std::ofstream text(path);
    text.precision(17);
    text << "[mesh]\nfile = \"mesh.su2\"\n\n[[boundary]]\nname = \"inner\"\ndegree = 3\nclosed = "
            "true\ncontrol_points = [\n";
    for (int i = 0; i < kCount; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCount;
        text << "    [" << control_radius(kCount) * std::cos(angle) << ", "
             << control_radius(kCount) * std::sin(angle) << "],\n";
    }
    text << "]\ndisplacements = [\n";
    for (int i = 0; i < kCount; ++i)
        text << "    [" << 0.02 * i << ", " << -0.01 * i << "],\n";
    text << "]\n\n[output]\nmesh = \"moved.su2\"\n";
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::cerr << "usage: make_case VERTICES FOLDER\n";
        return 2;
    }
    const std::string folder = argv[2];
    using namespace morph;
    write_mesh_data(bench::triangulated_annulus(std::atoi(argv[1]), bench::Order::shuffled),
                    folder + "/mesh.su2");
    write_case(folder + "/case.toml");
    return 0;
}
