#pragma once

#include "tools/case/toml_table.h"

#include <optional>
#include <string>

namespace morph::tools {

/// What the methods of [deform] can be told, each in a table of its name. Numbers that are not given take the
/// defaults of the library.
struct MethodOptions {
    struct Rbf {
        std::string function = "wendland-c2";
        double support = 0; ///< length unit of the mesh; 0: by the size of what moves
        bool linear = true;
        std::optional<double> tolerance; ///< choose centres until they meet it; without: all held vertices
    } rbf;
    struct Idw {
        std::optional<double> far_exponent;
        std::optional<double> near_exponent;
        std::optional<double> reach;
        std::optional<double> stiffness;
    } idw;
    struct Elasticity {
        std::string modulus = "inverse-area";
        double poisson_ratio = 0.3;
    } elasticity;
    struct Spring {
        std::string stiffness = "inverse-length-squared";
        std::string bracing = "torsion";
    } spring;
    struct Biharmonic {
        std::string condition = "conformal"; ///< or "clamped"
    } biharmonic;
};

/// The keys that method_options() reads.
const std::vector<std::string>& method_option_keys();

/// Read the tables of methods in [deform].
/// @throws InputError  "case.toml:12: what is wrong"
MethodOptions method_options(const TomlTable& deform);

} // namespace morph::tools
