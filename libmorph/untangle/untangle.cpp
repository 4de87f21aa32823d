#include "libmorph/untangle/untangle.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/core/predicates.h"
#include "libmorph/quality/quality.h"
#include "libmorph/untangle/newton.h"
#include "libmorph/untangle/patch.h"
#include "libmorph/untangle/reinitialize.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

constexpr int kGrowths = 2;              // sizes of patches that are tried before the whole mesh is
constexpr std::size_t kPatchDivisor = 4; // the first patches take in at most the mesh divided by this ...
constexpr std::size_t kPatchVertices = 20'000; // ... or so many vertices
constexpr int kWholeMesh = -1;                 // rings

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

void require_rows(const Mesh& mesh, const PositionsView& x, const char* what)
{
    if (x.rows() != vertex_count(mesh))
        throw InputError(std::string(what) + " has " + std::to_string(x.rows()) + " rows, but the mesh has " +
                         std::to_string(vertex_count(mesh)) + " vertices");
    if (!x.allFinite())
        throw InputError(std::string(what) + " is not finite everywhere");
}

void require_valid(const Mesh& mesh, const PositionsView& reference, const std::vector<Index>& held,
                   const PositionsView& positions)
{
    if (mesh.dimension != 2)
        throw InputError("untangling needs a planar mesh, but this is a surface in space");
    require_rows(mesh, reference, "the matrix of reference positions");
    require_rows(mesh, positions, "the matrix of positions");
    for (const Index v : held)
        if (v < 0 || v >= vertex_count(mesh))
            throw InputError("held vertex " + std::to_string(v) + " is out of range, there are " +
                             std::to_string(vertex_count(mesh)) + " vertices");
}

void require_valid(const UntangleOptions& options)
{
    if (!(options.size >= 0) || !(options.exponent >= 1))
        throw InputError("the energy of untangling has the size weight " + std::to_string(options.size) +
                         " and the exponent " + std::to_string(options.exponent) +
                         ", but they must be at least 0 and 1");
    if (options.rings < 1 || options.iterations < 1)
        throw InputError("untangling was asked to use " + std::to_string(options.rings) + " rings and " +
                         std::to_string(options.iterations) + " iterations, but both must be at least 1");
}

class Untangler {
public:
    Untangler(const Mesh& mesh, const PositionsView& reference, const std::vector<Index>& held,
              Eigen::Ref<Points>& positions, const UntangleOptions& options)
        : mesh_(mesh), stars_(mesh), reference_(reference), positions_(positions), options_(options),
          held_(at(vertex_count(mesh))), given_up_(at(element_count(mesh)))
    {
        for (const Index v : held)
            held_[at(stars_.vertex_of[at(v)])] = 1;
    }

    void run(UntangleResult& result)
    {
        give_up(result.unrepairable);
        const std::vector<Index> first = repairable(result);
        int rings = grow_patches(result);
        if (options_.reinitialize && !repairable(result).empty())
            rings = start_afresh(result);
        if (repairable(result).empty())
            spread(find_patches(stars_, held_, first, rings), result);
    }

    void certify(UntangleResult& result) const
    {
        result.inverted = inverted_elements(mesh_, positions_);
        result.unrepairable.clear();
        std::copy_if(result.inverted.begin(), result.inverted.end(), std::back_inserter(result.unrepairable),
                     [&](Index f) { return is_hopeless(stars_.elements[at(f)]); });
        result.valid = result.inverted.empty();
    }

private:
    /// Repair patches of more and more rings; returns the number that comes next.
    int grow_patches(UntangleResult& result)
    {
        int rings = first_rings(repairable(result));
        for (int growth = 0; growth < kGrowths && !repairable(result).empty(); ++growth, rings *= 2) {
            std::vector<Patch> patches = find_patches(stars_, held_, repairable(result), rings);
            if (growth > 0 && count_free(patches) > kPatchVertices / 2)
                break; // a fresh start costs less
            repair(std::move(patches), result);
        }
        return rings;
    }

    /// Rings around the inverted elements: more than asked for where those are a large heap, which takes
    /// about as much room around it; fewer where they are small but so many that patches would take in most
    /// of the mesh.
    int first_rings(const std::vector<Index>& inverted) const
    {
        Index heap = 0; // vertices of the largest
        for (const Patch& patch : find_patches(stars_, held_, inverted, 0))
            heap = std::max(heap, patch.free);
        int rings = static_cast<int>(std::sqrt(heap));
        if (rings > options_.rings)
            return rings;
        rings = options_.rings;
        while (rings > 1 && count_free(find_patches(stars_, held_, inverted, rings)) > limit())
            rings /= 2;
        return rings;
    }

    std::size_t limit() const { return std::max(kPatchVertices, held_.size() / kPatchDivisor); }

    /// Let more vertices share in what the repair of the first ones has left of distortion.
    void spread(std::vector<Patch> patches, UntangleResult& result)
    {
        if (count_free(patches) <= limit())
            repair(std::move(patches), result);
    }

    static std::size_t count_free(const std::vector<Patch>& patches)
    {
        std::size_t sum = 0;
        for (const Patch& patch : patches)
            sum += at(patch.free);
        return sum;
    }

    /// Forget where the free vertices are, and take the whole mesh if need be; what even then stays inverted
    /// is left out of another try from where they were. Returns the number of rings that comes next.
    int start_afresh(UntangleResult& result)
    {
        const auto move = spread_move(mesh_, stars_, reference_, held_, positions_);
        const Points before = positions_;
        for (std::size_t v = 0; move && v < held_.size(); ++v)
            if (const Index first = stars_.vertex_of[v]; !held_[at(first)])
                positions_.row(static_cast<Index>(v)).head<2>() =
                    reference_.row(first).head<2>() + move->row(first);
        certify(result);
        const int rings = grow_patches(result);
        if (!repairable(result).empty())
            repair(find_patches(stars_, held_, {}, kWholeMesh), result, true);
        const std::vector<Index> left = repairable(result);
        if (left.empty())
            return rings;
        give_up(left);
        positions_ = before;
        certify(result);
        return grow_patches(result);
    }

    /// What cannot be repaired must not keep its neighbours from it: it counts no more.
    void give_up(const std::vector<Index>& elements)
    {
        for (const Index f : elements)
            given_up_[at(f)] = 1;
    }

    std::vector<Index> repairable(const UntangleResult& result) const
    {
        std::vector<Index> list;
        std::copy_if(result.inverted.begin(), result.inverted.end(), std::back_inserter(list),
                     [&](Index f) { return !given_up_[at(f)]; });
        return list;
    }

    PlanePoint point(Index v) const { return {positions_(v, 0), positions_(v, 1)}; }

    bool is_hopeless(const Element& element) const
    {
        const auto n = static_cast<std::size_t>(corner_count(element));
        for (std::size_t k = 0; k < n; ++k) {
            const Index a = element[k], b = element[(k + 1) % n], c = element[(k + n - 1) % n];
            if (held_[at(a)] && held_[at(b)] && held_[at(c)] &&
                orientation(point(a), point(b), point(c)) <= 0)
                return true;
        }
        return false;
    }

    /// Repair what can be; @p anyhow: also move the vertices of patches that are not.
    void repair(std::vector<Patch> patches, UntangleResult& result, bool anyhow = false)
    {
        std::vector<int> iterations(patches.size());
        parallel_for(patches.size(), 1,
                     [&](std::size_t i, std::size_t) { iterations[i] = repair(patches[i], anyhow); });
        for (std::size_t i = 0; i < patches.size(); ++i) {
            result.patch_vertices += patches[i].free;
            result.iterations += iterations[i];
        }
        for (std::size_t v = 0; v < held_.size(); ++v)
            if (const Index first = stars_.vertex_of[v]; first != static_cast<Index>(v) && !held_[at(first)])
                positions_.row(static_cast<Index>(v)) = positions_.row(first);
        certify(result);
    }

    int repair(Patch& patch, bool anyhow)
    {
        set_targets(patch, stars_, reference_, given_up_);
        PlanePositions x;
        for (const Index v : patch.vertices)
            x.emplace_back(positions_(v, 0), positions_(v, 1));
        const PatchResult outcome =
            minimize(patch, {options_.size, options_.exponent}, options_.iterations, x);
        for (Index i = 0; (outcome.positive || anyhow) && i < patch.free; ++i) {
            positions_(patch.vertices[at(i)], 0) = x[at(i)].real();
            positions_(patch.vertices[at(i)], 1) = x[at(i)].imag();
        }
        return outcome.iterations;
    }

    const Mesh& mesh_;
    VertexStars stars_;
    const PositionsView& reference_;
    Eigen::Ref<Points>& positions_;
    const UntangleOptions& options_;
    std::vector<char> held_;     // by the vertex that stands for it
    std::vector<char> given_up_; // by element
};

} // namespace

UntangleResult
untangle(const Mesh& mesh, const PositionsView& reference, const std::vector<Index>& held,
         Eigen::Ref<Points> positions, // NOLINT(performance-unnecessary-value-param): it is a view
         const UntangleOptions& options)
{
    require_valid(mesh, reference, held, positions);
    require_valid(options);
    UntangleResult result;
    result.inverted = inverted_elements(mesh, positions);
    result.valid = result.inverted.empty();
    if (result.valid)
        return result;
    Untangler untangler(mesh, reference, held, positions, options);
    untangler.certify(result);
    untangler.run(result);
    return result;
}

} // namespace morph
