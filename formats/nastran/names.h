#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace morph {

/// Names of properties (PSHELL 3, PROD 4, …), which bulk data has in comments only:
///
///     $ANSA_NAME_COMMENT;3;PSHELL;wing;…         ANSA
///     $ANSA_NAME;3;PSHELL;~  and  $wing  on the next line
///     $HMNAME PROP                   3"wing" 4   HyperMesh; COMP where there is no PROP
///     $ Femap Property 3 : wing                  Femap
///     $ group 3 wing, $ marker 4 farfield, $ ungrouped 1      our own, as line_name() writes names
class NastranNames {
public:
    void take(std::string_view comment);

    /// Name of a property, or nothing.
    std::optional<std::string> name(Index property) const;

    /// Of our own comments, by property: a file of ours names all there are.
    const std::map<Index, std::string>& groups() const { return groups_; }
    const std::map<Index, std::string>& markers() const { return markers_; }
    bool is_ungrouped(Index property) const { return ungrouped_ == property; }

private:
    bool take_own(std::string_view comment);
    bool take_ansa(std::string_view comment);
    void take_hypermesh(std::string_view comment);
    void take_femap(std::string_view comment);

    std::map<Index, std::string> groups_, markers_, properties_, components_;
    Index ungrouped_ = -1;
    Index named_next_ = -1; ///< property whose name is the next comment
};

} // namespace morph
