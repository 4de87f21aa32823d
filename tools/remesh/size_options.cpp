#include "tools/remesh/size_options.h"

#include "tools/common/command_line.h"

namespace morph::tools {

void add_size_options(CommandLine& line, SizeSettings& options)
{
    const Option size = line.add("--size", options.size,
                                 "Target edge length everywhere; with --curvature or --adapt the largest")
                            .positive()
                            .type_name("H");
    const Option field = line.add("--size-field", options.size_field,
                                  "Nodal field of IN with the target edge lengths (default: those IN has)")
                             .excludes(size)
                             .type_name("NAME");
    const Option curvature =
        line.add("--curvature", options.curvature,
                 "Chord error of edges along boundary curves or on a surface, in lengths of the mesh:\n"
                 "edges of sqrt(8 E r) at radius r, at most --size, the field, or a tenth of the\n"
                 "bounding box's diagonal")
            .positive()
            .type_name("E");
    line.add("--adapt", options.adapt,
             "Nodal field of IN: the sizes that make its interpolation error least in the mean (L2)\n"
             "for --vertices (default: as many as IN has)")
        .excludes(field)
        .excludes(curvature)
        .type_name("NAME");
    line.add("--scale", options.scale, "Factor on the target edge lengths").show_default().positive();
    line.add("--vertices", options.vertices, "Scale them further, to about this many vertices")
        .range(3, 100000000)
        .type_name("N");
    line.add("--gradation", options.gradation,
             "Edges that follow each other differ in length by at most this factor (default: 1.2 with\n"
             "--size-field, --curvature or --adapt, else as they do in IN)")
        .above(1);
}

} // namespace morph::tools
