#include "libmorph/numerics/tree_walk.h"

#include "libmorph/core/parallel.h"

#include <algorithm>
#include <vector>

namespace morph {

namespace {

constexpr Index kBranches = 64;         // a branch for one thread has about this part of the rows ...
constexpr Index kSmallestBranch = 2000; // ... and no fewer than this

/// The tree cut into branches, consecutive nodes each, and the levels of what is above them.
struct Schedule {
    struct Branch {
        std::size_t begin, end; // nodes
    };
    std::vector<Branch> branches;
    std::vector<std::vector<std::size_t>> levels; // of single nodes, from the branches to the roots
};

Schedule schedule(const Dissection& tree)
{
    const std::size_t nodes = tree.nodes.size();
    const auto limit = std::max(static_cast<Index>(tree.order.size()) / kBranches, kSmallestBranch);
    std::vector<Index> first_row(nodes), height(nodes);
    std::vector<std::size_t> first_node(nodes);
    Schedule plan;
    for (std::size_t i = 0; i < nodes; ++i) {
        const Dissection::Node& node = tree.nodes[i];
        const auto child = static_cast<std::size_t>(node.children[0]);
        const bool leaf = node.children[0] < 0;
        first_row[i] = leaf ? node.begin : first_row[child];
        first_node[i] = leaf ? i : first_node[child];
        if (node.end - first_row[i] <= limit)
            continue;
        for (const Index c : node.children)
            if (c >= 0) {
                const auto below = static_cast<std::size_t>(c);
                height[i] = std::max(height[i], height[below]);
                if (height[below] == 0)
                    plan.branches.push_back({first_node[below], below + 1});
            }
        ++height[i];
        plan.levels.resize(std::max(plan.levels.size(), static_cast<std::size_t>(height[i])));
        plan.levels[static_cast<std::size_t>(height[i]) - 1].push_back(i);
    }
    for (std::size_t i = 0; i < nodes; ++i)
        if (tree.nodes[i].parent < 0 && height[i] == 0)
            plan.branches.push_back({first_node[i], i + 1});
    return plan;
}

} // namespace

void walk_up(const Dissection& tree, const std::function<void(std::size_t)>& visit)
{
    const Schedule plan = schedule(tree);
    parallel_for(plan.branches.size(), 1, [&](std::size_t b, std::size_t) {
        for (std::size_t i = plan.branches[b].begin; i < plan.branches[b].end; ++i)
            visit(i);
    });
    for (const auto& level : plan.levels)
        parallel_for(level.size(), 1, [&](std::size_t i, std::size_t) { visit(level[i]); });
}

void walk_down(const Dissection& tree, const std::function<void(std::size_t)>& visit)
{
    const Schedule plan = schedule(tree);
    for (auto level = plan.levels.rbegin(); level != plan.levels.rend(); ++level)
        parallel_for(level->size(), 1, [&](std::size_t i, std::size_t) { visit((*level)[i]); });
    parallel_for(plan.branches.size(), 1, [&](std::size_t b, std::size_t) {
        for (std::size_t i = plan.branches[b].end; i-- > plan.branches[b].begin;)
            visit(i);
    });
}

} // namespace morph
