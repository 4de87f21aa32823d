#include "tools/common/command_line.h"

#include "formats/format.h"
#include "libmorph/core/names.h"
#include "libmorph/core/parallel.h"
#include "tools/common/progress_bar.h"
#include "tools/common/run.h"

#include <iostream>

namespace morph::tools {

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

} // namespace

CommandLine::CommandLine(const std::string& tool, const std::string& description, const std::string& example)
    : app_(description, tool)
{
    app_.set_version_flag("--version", std::string(tool) + " (libmorph) " MORPH_VERSION);
    app_.add_option("--json", common_.json, "Write what was done as JSON to FILE (-: standard output)")
        ->type_name("FILE");
    app_.add_option("--threads", common_.threads,
                    "Use N threads (default: every core); the result is the same")
        ->type_name("N")
        ->check(CLI::Range(0, 1024));
    app_.add_flag("--quiet", common_.quiet, "Print nothing but errors");
    app_.allow_extras();
    app_.footer(std::string(kExitCodes) + "\n\nExample:\n" + example);
}

void CommandLine::add_from(std::string& from)
{
    app_.add_option("--from", from,
                    "Format of the input, when its extension does not tell: " + format_names())
        ->type_name("NAME");
}

void CommandLine::add_to(std::string& to)
{
    app_.add_option("--to", to, "Format of the output, when its extension does not tell")->type_name("NAME");
}

std::string CommandLine::unknown_options() const
{
    std::vector<std::string> known;
    for (const CLI::Option* option : app_.get_options())
        for (const std::string& name : option->get_lnames())
            known.push_back("--" + name);
    const std::string extra = app_.remaining().front();
    if (extra.rfind('-', 0) == 0)
        return "unknown option '" + extra + "'" + did_you_mean(extra, known) + "; --help lists the options";
    return "unexpected argument '" + extra + "'; --help shows the usage";
}

bool CommandLine::parse(int argc, char** argv)
{
    try {
        app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app_.help();
        return false;
    } catch (const CLI::CallForVersion& version) {
        std::cout << version.what() << '\n';
        return false;
    } catch (const CLI::ParseError& error) {
        const bool unknown = !app_.remaining().empty();
        throw UsageError(unknown ? unknown_options()
                                 : std::string(error.what()) + "; --help shows the usage");
    }
    if (!app_.remaining().empty())
        throw UsageError(unknown_options());
    set_thread_count(common_.threads);
    set_quiet(common_.quiet);
    if (!common_.quiet)
        show_progress_bar();
    return true;
}

} // namespace morph::tools
