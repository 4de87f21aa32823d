#include "formats/abaqus/sets.h"

#include "formats/text/message_text.h"

#include <algorithm>
#include <charconv>

namespace morph {

namespace {

bool is_id(std::string_view field, Index& id)
{
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), id);
    return error == std::errc() && end == field.data() + field.size() && id >= 0;
}

} // namespace

std::size_t AbaqusSets::set_called(const std::string& name)
{
    const auto [entry, is_new] = numbers_.try_emplace(upper_case(name), sets_.size());
    if (is_new) {
        sets_.push_back({name, {}, false});
        sources_.emplace_back();
    }
    return entry->second;
}

const AbaqusSets::Set* AbaqusSets::find(const std::string& name) const
{
    const std::size_t number = number_of(name);
    return number == sets_.size() ? nullptr : &sets_[number];
}

/// The number of sets when there is none of this name.
std::size_t AbaqusSets::number_of(const std::string& name) const
{
    const auto found = numbers_.find(upper_case(name));
    return found == numbers_.end() ? sets_.size() : found->second;
}

void AbaqusSets::add_run(const std::string& name, Index begin, Index end, bool is_lines)
{
    const std::size_t set = set_called(name);
    sets_[set].is_lines = sets_[set].is_lines || is_lines;
    sources_[set].items.push_back({ItemKind::run, begin, end, 1, "", 0});
}

void AbaqusSets::read(AbaqusLines& lines, const std::string& name, bool generate)
{
    std::vector<Item>& items = sources_[set_called(name)].items;
    while (lines.next_data_line()) {
        const std::size_t position = lines.scanner().position();
        if (generate) {
            const Index first = lines.index("the first id of a range");
            const Index last = lines.index("the last id of a range");
            const Index step = lines.at_line_end() ? 1 : lines.index("the step of a range");
            if (step < 1 || last < first)
                lines.scanner().fail_at(position, "the range " + std::to_string(first) + " to " +
                                                      std::to_string(last) + " by " + std::to_string(step) +
                                                      " has no members");
            items.push_back({ItemKind::range, first, last, step, "", position});
            lines.end_line("a range");
            continue;
        }
        std::string field;
        while (lines.try_field(field)) {
            Index id = 0;
            if (is_id(without_instance(field), id))
                items.push_back({ItemKind::id, id, id, 1, "", position});
            else if (!field.empty())
                items.push_back({ItemKind::set, 0, 0, 1, field, position});
        }
        lines.scanner().skip_line();
    }
}

/// Finds the members of one set after those of the sets that it names.
class AbaqusSets::Resolver {
public:
    Resolver(AbaqusSets& sets, const IdTable& table, const TextScanner& in, const std::string& what)
        : sets_(sets), table_(table), in_(in), what_(what),
          owner_(static_cast<std::size_t>(table.count()), none)
    {
    }

    void resolve(std::size_t set)
    {
        Source& source = sets_.sources_[set];
        if (source.state != State::open)
            return;
        source.state = State::being_resolved;
        for (const Item& item : source.items)
            if (item.kind == ItemKind::set)
                resolve(named(set, item));
        for (const Item& item : source.items)
            take(set, item);
        source.items.clear();
        source.state = State::resolved;
    }

private:
    static constexpr std::size_t none = ~std::size_t{0};

    void add(std::size_t set, Index member)
    {
        if (member < 0 || owner_[static_cast<std::size_t>(member)] == set)
            return;
        owner_[static_cast<std::size_t>(member)] = set;
        sets_.sets_[set].members.push_back(member);
    }

    void take(std::size_t set, const Item& item)
    {
        if (item.kind == ItemKind::id)
            add(set, member(set, item));
        else if (item.kind == ItemKind::range)
            take_range(set, item);
        else if (item.kind == ItemKind::run)
            for (Index member = item.first; member < item.last; ++member)
                add(set, member);
        else if (const std::size_t other = named(set, item); other != set)
            for (const Index member : sets_.sets_[other].members)
                add(set, member);
    }

    Index member(std::size_t set, const Item& item) const
    {
        const Index member = table_.find(item.first);
        if (member < 0)
            in_.fail_at(item.position, "the set " + quoted_text(sets_.sets_[set].name) + " names " + what_ +
                                           " " + std::to_string(item.first) +
                                           ", but there is none of this id");
        return member;
    }

    /// By ids, or by what is there where that is less.
    void take_range(std::size_t set, const Item& item)
    {
        if ((item.last - item.first) / item.step <= table_.count())
            for (std::int64_t id = item.first; id <= item.last; id += item.step)
                add(set, table_.find(static_cast<Index>(id)));
        else
            for (Index member = 0; member < table_.count(); ++member) {
                const Index id = table_.id(member);
                if (id >= item.first && id <= item.last && (id - item.first) % item.step == 0)
                    add(set, member);
            }
    }

    std::size_t named(std::size_t set, const Item& item) const
    {
        const std::size_t plain = sets_.number_of(item.name);
        const std::size_t other =
            plain < sets_.sets_.size() ? plain : sets_.number_of(without_instance(item.name));
        if (other == sets_.sets_.size())
            in_.fail_at(item.position, "the set " + quoted_text(sets_.sets_[set].name) + " names the set " +
                                           quoted_text(item.name) + ", which is not there");
        return other;
    }

    AbaqusSets& sets_;
    const IdTable& table_;
    const TextScanner& in_;
    const std::string& what_;
    std::vector<std::size_t> owner_; ///< of each member, the set that took it last
};

void AbaqusSets::resolve(const IdTable& table, const TextScanner& in, const std::string& what)
{
    Resolver resolver(*this, table, in, what);
    for (std::size_t set = 0; set < sets_.size(); ++set)
        resolver.resolve(set);
}

} // namespace morph
