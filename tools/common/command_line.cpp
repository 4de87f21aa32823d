#include "tools/common/command_line.h"

#include "formats/format.h"
#include "libmorph/core/names.h"
#include "libmorph/core/parallel.h"
#include "tools/common/progress_bar.h"
#include "tools/common/run.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <iostream>

namespace morph::tools {

struct CommandLine::Parser {
    CLI::App app;
    CommonOptions common;
};

namespace {

constexpr const char* kExitCodes =
    "Exit status: 0 done, 1 bad input or failure, 2 wrong usage,\n"
    "3 done and written, but the resulting mesh has inverted elements or crosses itself";

std::string format_names()
{
    std::vector<std::string> names;
    for (const Format* format : all_formats())
        names.emplace_back(format->name);
    return joined(names);
}

std::string about_unknown(const CLI::App& app)
{
    std::vector<std::string> known;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            known.push_back("--" + name);
    const std::string extra = app.remaining().front();
    if (extra.rfind('-', 0) == 0)
        return "unknown option '" + extra + "'" + did_you_mean(extra, known) + "; --help lists the options";
    return "unexpected argument '" + extra + "'; --help shows the usage";
}

} // namespace

Option Option::required() const
{
    option_->required();
    return *this;
}

Option Option::type_name(const std::string& name) const
{
    option_->type_name(name);
    return *this;
}

Option Option::show_default() const
{
    option_->capture_default_str();
    return *this;
}

Option Option::one_of(const std::vector<std::string>& values) const
{
    option_->check(CLI::IsMember(values));
    return *this;
}

Option Option::range(int lowest, int highest) const
{
    option_->check(CLI::Range(lowest, highest));
    return *this;
}

Option Option::range(double lowest, double highest) const
{
    option_->check(CLI::Range(lowest, highest));
    return *this;
}

Option Option::positive() const
{
    option_->check(CLI::PositiveNumber);
    return *this;
}

Option Option::above(double excluded) const
{
    const std::string limit = "above " + number_text(excluded);
    option_->check(
        [excluded, limit](const std::string& text) {
            const std::optional<double> value = number_in(text);
            return value && *value > excluded && std::isfinite(*value)
                       ? std::string()
                       : "'" + text + "' is not a number " + limit;
        },
        "FLOAT " + limit);
    return *this;
}

Option Option::excludes(const Option& other) const
{
    option_->excludes(other.option_);
    return *this;
}

Option Option::excludes(const std::string& name) const
{
    option_->excludes(name);
    return *this;
}

Option Option::one_value_each_time() const
{
    option_->allow_extra_args(false);
    return *this;
}

Option Option::comma_separated() const
{
    option_->delimiter(',');
    return *this;
}

Option Option::count(int fewest, int most) const
{
    option_->expected(fewest, most);
    return *this;
}

CommandLine::CommandLine(const std::string& tool, const std::string& description, const std::string& example)
    : parser_(new Parser{CLI::App(description, tool), {}})
{
    CommonOptions& common = parser_->common;
    parser_->app.set_version_flag("--version", tool + " (libmorph) " MORPH_VERSION);
    add("--json", common.json, "Write what was done as JSON to FILE (-: standard output)").type_name("FILE");
    add("--threads", common.threads, "Use N threads (default: every core); the result is the same")
        .type_name("N")
        .range(0, 1024);
    add_flag("--quiet", common.quiet, "Print nothing but errors");
    parser_->app.allow_extras();
    parser_->app.footer(std::string(kExitCodes) + "\n\nExample:\n" + example);
}

CommandLine::~CommandLine() = default;

template <typename Value>
Option CommandLine::add(const std::string& names, Value& value, const std::string& help)
{
    return Option(*parser_->app.add_option(names, value, help));
}

Option CommandLine::add_flag(const std::string& names, bool& value, const std::string& help)
{
    return Option(*parser_->app.add_flag(names, value, help));
}

void CommandLine::add_from(std::string& from)
{
    add("--from", from, "Format of the input, when its extension does not say: " + format_names())
        .type_name("NAME");
}

void CommandLine::add_to(std::string& to)
{
    add("--to", to, "Format of the output, when its extension does not say").type_name("NAME");
}

bool CommandLine::parse(int argc, char** argv)
{
    CLI::App& app = parser_->app;
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return false;
    } catch (const CLI::CallForVersion& version) {
        std::cout << version.what() << '\n';
        return false;
    } catch (const CLI::ParseError& error) {
        const bool unknown = !app.remaining().empty();
        throw UsageError(unknown ? about_unknown(app)
                                 : std::string(error.what()) + "; --help shows the usage");
    }
    if (!app.remaining().empty())
        throw UsageError(about_unknown(app));
    const CommonOptions& common = parser_->common;
    set_thread_count(common.threads);
    set_quiet(common.quiet);
    if (!common.quiet)
        show_progress_bar();
    return true;
}

const CommonOptions& CommandLine::common() const
{
    return parser_->common;
}

bool CommandLine::given(const std::string& name) const
{
    return parser_->app.count(name) > 0;
}

std::optional<double> number_in(const std::string& text)
{
    double value = 0;
    return CLI::detail::lexical_cast(text, value) ? std::optional(value) : std::nullopt;
}

template Option CommandLine::add(const std::string&, std::string&, const std::string&);
template Option CommandLine::add(const std::string&, int&, const std::string&);
template Option CommandLine::add(const std::string&, double&, const std::string&);
template Option CommandLine::add(const std::string&, std::vector<std::string>&, const std::string&);
template Option CommandLine::add(const std::string&, std::vector<double>&, const std::string&);

} // namespace morph::tools
