#include "formats/case/entries.h"

namespace morph {

namespace {

/// Keeps @p value where the key is missing.
template <typename Value>
void take(const std::optional<Value>& given, Value& value)
{
    value = given.value_or(value);
}

std::optional<double> positive(const TomlTable& table, const std::string& key)
{
    const auto value = table.number(key);
    if (value && !(*value > 0))
        table.fail(table.line(key), "[deform] " + key + " must be above 0");
    return value;
}

void read_rbf(const TomlTable& table, DeformSettings& deform)
{
    table.require_known({"function", "support", "linear", "tolerance"});
    take(table.choice<RadialFunction>("function"), deform.rbf.function);
    take(positive(table, "support"), deform.rbf.support);
    take(table.boolean("linear"), deform.rbf.linear);
    deform.rbf_tolerance = positive(table, "tolerance");
}

void read_idw(const TomlTable& table, IdwOptions& idw)
{
    table.require_known({"far_exponent", "near_exponent", "reach", "stiffness"});
    take(positive(table, "far_exponent"), idw.far_exponent);
    take(positive(table, "near_exponent"), idw.near_exponent);
    take(positive(table, "reach"), idw.reach);
    take(table.number("stiffness"), idw.stiffness);
}

void read_elasticity(const TomlTable& table, Elasticity& elasticity)
{
    table.require_known({"modulus", "poisson_ratio"});
    take(table.choice<YoungsModulus>("modulus"), elasticity.modulus);
    take(table.number("poisson_ratio"), elasticity.poisson_ratio);
}

void read_spring(const TomlTable& table, SpringOptions& spring)
{
    table.require_known({"stiffness", "bracing"});
    take(table.choice<SpringStiffness>("stiffness"), spring.stiffness);
    take(table.choice<SpringBracing>("bracing"), spring.bracing);
}

void read_biharmonic(const TomlTable& table, BiharmonicCondition& condition)
{
    table.require_known({"condition"});
    take(table.choice<BiharmonicCondition>("condition"), condition);
}

} // namespace

const std::vector<std::string>& method_option_keys()
{
    static const std::vector<std::string> keys{"rbf", "idw", "elasticity", "spring", "biharmonic"};
    return keys;
}

void read_method_options(const TomlTable& table, DeformSettings& deform)
{
    const auto of = [&](const std::string& key) { return table.table(key, "[deform." + key + "]"); };
    if (const auto rbf = of("rbf"))
        read_rbf(*rbf, deform);
    if (const auto idw = of("idw"))
        read_idw(*idw, deform.idw);
    if (const auto elasticity = of("elasticity"))
        read_elasticity(*elasticity, deform.elasticity);
    if (const auto spring = of("spring"))
        read_spring(*spring, deform.spring);
    if (const auto biharmonic = of("biharmonic"))
        read_biharmonic(*biharmonic, deform.biharmonic);
}

} // namespace morph
