#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class Option;
}

namespace morph::tools {

/// What every tool takes.
struct CommonOptions {
    std::string json; ///< file for the report, "-" for standard output, empty for none
    bool quiet = false;
    int threads = 0; ///< 0: every core
};

/// An option that was added to a command line: what --help shows of it and which values it accepts. A value
/// that it does not accept is a UsageError of CommandLine::parse(). Cheap to copy.
class Option {
public:
    Option required() const;
    Option type_name(const std::string& name) const; ///< what --help shows in the place of a value
    Option show_default() const;                     ///< --help shows the value that the variable has now

    Option one_of(const std::vector<std::string>& values) const;
    Option range(int lowest, int highest) const; ///< both ends included
    Option range(double lowest, double highest) const;
    Option positive() const;             ///< a finite number above 0
    Option above(double excluded) const; ///< a finite number above this

    Option excludes(const Option& other) const;
    Option excludes(const std::string& name) const; ///< of an option that was added before

    /// How a list takes its values: by default all arguments up to the next option, and the option again.
    Option one_value_each_time() const; ///< several only by the option again
    Option comma_separated() const;     ///< and several in one argument
    Option count(int fewest, int most) const;

private:
    friend class CommandLine;
    explicit Option(CLI::Option& option) : option_(&option) {}

    CLI::Option* option_;
};

/// The command line of one tool: its own options, after the common ones, which are already there.
class CommandLine {
public:
    /// @param example  a worked example, the last thing --help prints
    CommandLine(const std::string& tool, const std::string& description, const std::string& example);
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

    /// Add an option, or a positional argument where the name has no dashes. parse() writes its value into
    /// @p value, which keeps its own where the option is not given.
    /// @tparam Value  std::string, int, double, std::vector of std::string or double; another type is one
    /// more
    ///                line at the end of command_line.cpp
    /// @param names   separated by commas, as in "-o,--output"
    template <typename Value>
    Option add(const std::string& names, Value& value, const std::string& help);

    /// Add an option without a value; "--edges,!--no-edges" has a name that switches off.
    Option add_flag(const std::string& names, bool& value, const std::string& help);

    /// --from and --to for the tools that read and write meshes.
    void add_from(std::string& from);
    void add_to(std::string& to);

    /// Takes the arguments and applies --threads and --quiet.
    /// @return false when --help or --version was asked for and has been answered
    /// @throws UsageError  unknown option (names the nearest), missing or extra argument, bad value
    bool parse(int argc, char** argv);

    const CommonOptions& common() const;

    /// Whether the option of this name was among the arguments.
    bool given(const std::string& name) const;

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
};

/// The number that the whole text is, as values of options are read; none if it is not one.
std::optional<double> number_in(const std::string& text);

} // namespace morph::tools
