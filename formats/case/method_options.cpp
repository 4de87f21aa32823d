#include "tools/case/method_options.h"

namespace morph::tools {

namespace {

std::optional<double> positive(const TomlTable& table, const std::string& key)
{
    const auto value = table.number(key);
    if (value && !(*value > 0))
        table.fail(table.line(key), "[deform] " + key + " must be above 0");
    return value;
}

MethodOptions::Rbf rbf_options(const TomlTable& table)
{
    table.require_known({"function", "support", "linear", "tolerance"});
    MethodOptions::Rbf rbf;
    rbf.function =
        table.choice("function", {"wendland-c0", "wendland-c2", "wendland-c4", "thin-plate", "gauss"})
            .value_or(rbf.function);
    rbf.support = positive(table, "support").value_or(rbf.support);
    rbf.linear = table.boolean("linear").value_or(rbf.linear);
    rbf.tolerance = positive(table, "tolerance");
    return rbf;
}

MethodOptions::Idw idw_options(const TomlTable& table)
{
    table.require_known({"far_exponent", "near_exponent", "reach", "stiffness"});
    return {positive(table, "far_exponent"), positive(table, "near_exponent"), positive(table, "reach"),
            table.number("stiffness")};
}

MethodOptions::Elasticity elasticity_options(const TomlTable& table)
{
    table.require_known({"modulus", "poisson_ratio"});
    MethodOptions::Elasticity elasticity;
    elasticity.modulus =
        table.choice("modulus", {"uniform", "inverse-distance", "inverse-area"}).value_or(elasticity.modulus);
    elasticity.poisson_ratio = table.number("poisson_ratio").value_or(elasticity.poisson_ratio);
    return elasticity;
}

MethodOptions::Spring spring_options(const TomlTable& table)
{
    table.require_known({"stiffness", "bracing"});
    MethodOptions::Spring spring;
    spring.stiffness =
        table.choice("stiffness", {"inverse-length", "inverse-length-squared"}).value_or(spring.stiffness);
    spring.bracing = table.choice("bracing", {"none", "torsion", "ball-vertex"}).value_or(spring.bracing);
    return spring;
}

MethodOptions::Biharmonic biharmonic_options(const TomlTable& table)
{
    table.require_known({"condition"});
    MethodOptions::Biharmonic biharmonic;
    biharmonic.condition = table.choice("condition", {"clamped", "conformal"}).value_or(biharmonic.condition);
    return biharmonic;
}

} // namespace

const std::vector<std::string>& method_option_keys()
{
    static const std::vector<std::string> keys{"rbf", "idw", "elasticity", "spring", "biharmonic"};
    return keys;
}

MethodOptions method_options(const TomlTable& deform)
{
    MethodOptions options;
    const auto table = [&](const std::string& key) { return deform.table(key, "[deform." + key + "]"); };
    if (const auto rbf = table("rbf"))
        options.rbf = rbf_options(*rbf);
    if (const auto idw = table("idw"))
        options.idw = idw_options(*idw);
    if (const auto elasticity = table("elasticity"))
        options.elasticity = elasticity_options(*elasticity);
    if (const auto spring = table("spring"))
        options.spring = spring_options(*spring);
    if (const auto biharmonic = table("biharmonic"))
        options.biharmonic = biharmonic_options(*biharmonic);
    return options;
}

} // namespace morph::tools
