// The cases of the thesis's chapter 4, rebuilt: a velocity carried between two meshes of one domain, both
// ways.
//   sh examples/remap/run.sh build/bin out/remap
// Before: remap_cases make OUT writes the meshes. After morph-remap has carried the velocity between them,
// remap_cases table OUT compares what came out with the velocity itself.
#include "examples/remap/cases.h"
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

/// What the table says of one result, which gets its error as a field.
struct Errors {
    Index targets = 0;
    int outside = 0;
    double largest_inside = 0;
    double largest_outside = 0;
    double mean_square = 0; ///< its square root
};

Errors errors_in(const std::string& file)
{
    Mesh mesh = read_mesh(file);
    const Field error = error_of(mesh);
    const Matrix& status = find_field(mesh.fields, "remap_status", FieldLocation::vertex)->values;
    Errors errors;
    errors.targets = vertex_count(mesh);
    errors.outside = static_cast<int>(status.sum());
    errors.largest_inside = ((1 - status.array()) * error.values.array()).maxCoeff();
    errors.largest_outside = status.cwiseProduct(error.values).maxCoeff();
    errors.mean_square = l2(mesh, error);
    mesh.fields.push_back(error);
    write_mesh(mesh, file);
    return errors;
}

void table(const std::string& folder)
{
    std::puts(
        "| case | direction | targets | outside | largest error inside | outside, idw | outside, project | "
        "L2, idw | L2, project |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for (const std::string name : {"pipe_triangles", "pipe_quads", "airfoil_hybrid"})
        for (const std::string way : {"coarse_to_fine", "fine_to_coarse"}) {
            const std::string file = std::string(folder).append("/").append(name).append("_").append(way);
            const Errors idw = errors_in(file + "_idw.vtu"), project = errors_in(file + "_project.vtu");
            std::printf("| %s | %s | %d | %d | %.2e | %.2e | %.2e | %.2e | %.2e |\n", name.c_str(),
                        way.c_str(), idw.targets, idw.outside, idw.largest_inside, idw.largest_outside,
                        project.largest_outside, idw.mean_square, project.mean_square);
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
