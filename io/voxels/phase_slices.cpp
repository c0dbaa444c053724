#include "io/voxels/phase_slices.h"

#include "io/voxels/typed_bytes.h"
#include "processing/volume/block_mean.h"

namespace echolucent {

/// Means of any stored type.
struct PhaseSlices::Means {
    Means() = default;
    Means(const Means&) = delete;
    Means& operator=(const Means&) = delete;
    virtual ~Means() = default;
    virtual void add(const VoxelBytes& slice) = 0;
    virtual void skip() = 0;

    static std::unique_ptr<Means> make(StoredType type, const Reduction& reduction, std::span<std::uint8_t> reduced);
    template <typename T>
    struct Of;
};

template <typename T>
struct PhaseSlices::Means::Of : Means {
    // The memory of byte vectors is aligned for every type.
    Of(const Reduction& reduction, std::span<std::uint8_t> reduced)
        : mean(reduction, {reinterpret_cast<T*>(reduced.data()), reduced.size() / sizeof(T)}) {}
    void add(const VoxelBytes& slice) override {
        mean.add({reinterpret_cast<const T*>(slice.data()), slice.size() / sizeof(T)});
    }
    void skip() override { mean.skip(); }
    BlockMean<T> mean;
};

std::unique_ptr<PhaseSlices::Means> PhaseSlices::Means::make(StoredType type, const Reduction& reduction,
                                                             std::span<std::uint8_t> reduced) {
    return withStoredType(
        type, [&]<typename T>(T) -> std::unique_ptr<Means> { return std::make_unique<Of<T>>(reduction, reduced); });
}

PhaseSlices::PhaseSlices(StoredType type, const std::array<std::int64_t, 3>& size,
                         const std::optional<Reduction>& reduction)
    : m_sliceBytes(static_cast<std::size_t>(size[0] * size[1] * bytesOf(type))) {
    const auto kept = reduction ? reducedSize(*reduction) : size;
    m_bytes.resize(static_cast<std::size_t>(kept[0] * kept[1] * kept[2] * bytesOf(type)));
    if (!reduction) return;
    m_stored.resize(m_sliceBytes);
    m_means = Means::make(type, *reduction, m_bytes);
}

PhaseSlices::PhaseSlices(PhaseSlices&&) noexcept = default;
PhaseSlices& PhaseSlices::operator=(PhaseSlices&&) noexcept = default;
PhaseSlices::~PhaseSlices() = default;

std::span<std::uint8_t> PhaseSlices::nextSlice() {
    if (m_means) return m_stored;
    return std::span(m_bytes).subspan(m_slice * m_sliceBytes, m_sliceBytes);
}

void PhaseSlices::endSlice() {
    if (m_means) m_means->add(m_stored);
    ++m_slice;
}

void PhaseSlices::skipSlice() {
    if (m_means) m_means->skip();
    ++m_slice;
}

}  // namespace echolucent
