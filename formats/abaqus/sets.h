#pragma once

#include "formats/abaqus/lines.h"
#include "formats/text/id_table.h"

#include <map>

namespace morph {

/// The sets of one kind, *ELSET or *NSET, by name (letter case aside). Members are ids, ranges of ids, other
/// sets, or runs of what was read last; a name that is there again adds to its set.
class AbaqusSets {
public:
    struct Set {
        std::string name;           ///< as it was first written
        std::vector<Index> members; ///< numbers in the table, each once; filled by resolve()
        bool is_lines = false;      ///< named by an *ELEMENT of lines, which may have none
    };

    /// Read the data lines of *ELSET or *NSET.
    /// @throws InputError  a line that is no range, with GENERATE
    void read(AbaqusLines& lines, const std::string& name, bool generate);

    /// Entries @p begin to @p end of the table are in the set (the parameter ELSET of *ELEMENT).
    void add_run(const std::string& name, Index begin, Index end, bool is_lines = false);

    /// Find the members of all sets. Members of ranges that do not exist are left out.
    /// @param what  for the message: "element"
    /// @throws InputError  an id or a set that is not there
    void resolve(const IdTable& table, const TextScanner& in, const std::string& what);

    const std::vector<Set>& sets() const { return sets_; }
    /// Null when there is none.
    const Set* find(const std::string& name) const;

private:
    enum class ItemKind { id, range, set, run };
    struct Item {
        ItemKind kind;
        Index first, last, step;
        std::string name;
        std::size_t position;
    };
    enum class State { open, being_resolved, resolved };
    struct Source {
        std::vector<Item> items;
        State state = State::open;
    };
    class Resolver;

    std::size_t set_called(const std::string& name);
    std::size_t number_of(const std::string& name) const;

    std::vector<Set> sets_;
    std::vector<Source> sources_;                ///< of each set
    std::map<std::string, std::size_t> numbers_; ///< by name in upper case
};

} // namespace morph
