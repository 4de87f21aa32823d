// Remesh a domain with triangles of half the size, its boundary layers kept.
//   remesh examples/naca0012_inv.su2 fine.su2
#include "formats/formats.h"
#include "libmorph/morph.h"

#include <iostream>

int main(int, char** argv)
{
    const morph::Mesh mesh = morph::read_mesh(argv[1]);
    morph::RemeshJob job;
    job.sizes.scale = 0.5;
    const morph::RemeshedMesh result = morph::remesh(mesh, job);
    const morph::RemeshCheck check = morph::check_remeshing(mesh, result.mesh, result.targets);
    std::cout << check.after.triangles << " triangles, smallest angle " << check.after.min_angle
              << " degrees, " << check.distance.value << " from the old boundary\n";
    morph::write_mesh_data(morph::to_mesh_data(result.mesh), argv[2]);
}
