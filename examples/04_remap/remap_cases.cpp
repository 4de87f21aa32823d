// The cases of the thesis's chapter 4, rebuilt: a velocity carried between two meshes of one domain, both
// ways.
//   sh examples/04_remap/run.sh build/bin out/remap
// Before: remap_cases make OUT writes the meshes. After morph-remap has carried the velocity between them,
// remap_cases table OUT compares what came out with the velocity itself.
#include "examples/04_remap/cases.h"
#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remap/integral.h"

#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

namespace {

using namespace morph;
using namespace morph::examples;

void make(const std::string& folder)
{
    for (const RemapCase& c : remap_cases())
        for (const auto& [size, mesh] : {std::pair{"coarse", &c.coarse}, std::pair{"fine", &c.fine}}) {
            write_mesh_data(*mesh, folder + "/" + c.name + "_" + size + ".su2");
            write_mesh_data(with_velocity(*mesh), folder + "/" + c.name + "_" + size + ".vtu");
        }
}

/// The distance of the carried velocity from the true one, as a nodal field.
Field error_of(const Mesh& mesh)
{
    const Matrix& carried = find_field(mesh.fields, "velocity", FieldLocation::vertex)->values;
    Field error{"error", FieldLocation::vertex, Matrix(vertex_count(mesh), 1)};
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const auto [x, y] = velocity(points(mesh)(v, 0), points(mesh)(v, 1));
        error.values(v, 0) = std::hypot(carried(v, 0) - x, carried(v, 1) - y);
    }
    return error;
}

/// Square root of the mean square over the mesh.
double l2(const Mesh& mesh, Field error)
{
    Field one{"one", FieldLocation::vertex, Matrix::Ones(vertex_count(mesh), 1)};
    error.values = error.values.cwiseAbs2();
    return std::sqrt(field_totals(mesh, error).integral[0] / field_totals(mesh, one).integral[0]);
}

void print_row(const std::string& name, const std::string& from, const std::string& to, Mesh& mesh)
{
    const Field error = error_of(mesh);
    const Matrix& status = find_field(mesh.fields, "remap_status", FieldLocation::vertex)->values;
    const double inside = (1 - status.array()).cwiseProduct(error.values.array()).maxCoeff();
    const double outside = status.cwiseProduct(error.values).maxCoeff();
    std::printf("| %s | %s to %s | %d | %d | %.2e | %.2e | %.2e |\n", name.c_str(), from.c_str(), to.c_str(),
                vertex_count(mesh), static_cast<int>(status.sum()), inside, outside, l2(mesh, error));
    mesh.fields.push_back(error);
}

void table(const std::string& folder)
{
    std::puts("| case | direction | target nodes | of them outside | largest error inside | outside | L2 |\n"
              "| --- | --- | --- | --- | --- | --- | --- |");
    for (const std::string name : {"pipe_triangles", "pipe_quads", "airfoil_hybrid"})
        for (const auto& [from, to] : {std::pair{"coarse", "fine"}, std::pair{"fine", "coarse"}}) {
            const std::string file = folder + "/" + name + "_" + from + "_to_" + to + ".vtu";
            Mesh mesh = read_mesh(file);
            print_row(name, from, to, mesh);
            write_mesh(mesh, file);
        }
}

} // namespace

int main(int argc, char** argv)
{
    const std::string job = argc == 3 ? argv[1] : "";
    try {
        if (job == "make")
            make(argv[2]);
        else if (job == "table")
            table(argv[2]);
        else
            std::cerr << "usage: remap_cases make|table FOLDER\n";
        return job == "make" || job == "table" ? 0 : 2;
    } catch (const std::exception& error) {
        std::cerr << "remap_cases: " << error.what() << '\n';
        return 1;
    }
}
