#include "io/writers/looped_pictures.h"

#include <zlib.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace echolucent {

namespace {

/// Frames by their numbers. Pictures of scans are largely black, and pack to a fifth.
class KeptFrames {
public:
    explicit KeptFrames(std::size_t mostBytes) : m_mostBytes(mostBytes) {}

    void keep(int frame, const MoviePicture& rgb) {
        std::string packed(compressBound(rgb.size()), '\0');
        uLongf size = packed.size();
        if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, rgb.data(), rgb.size(), Z_BEST_SPEED) != Z_OK)
            throw std::runtime_error("KeptFrames: a frame cannot be packed");
        if (m_bytes + size > m_mostBytes) return;
        m_bytes += size;
        m_packed[frame] = {std::string(packed.data(), size), rgb.size()};
    }
    /// Empty if the frame is not kept.
    [[nodiscard]] MoviePicture find(int frame) const {
        const auto kept = m_packed.find(frame);
        if (kept == m_packed.end()) return {};
        MoviePicture rgb(kept->second.size);
        uLongf size = rgb.size();
        const std::string& packed = kept->second.bytes;
        if (uncompress(rgb.data(), &size, reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
            size != rgb.size())
            throw std::runtime_error("KeptFrames: a frame cannot be unpacked");
        return rgb;
    }

private:
    struct Packed {
        std::string bytes;
        std::size_t size = 0;  ///< of the picture
    };
    std::size_t m_mostBytes, m_bytes = 0;
    std::map<int, Packed> m_packed;
};

}  // namespace

Result<void> addLooped(const std::vector<int>& frames, const std::function<Result<MoviePicture>(int)>& make,
                       const std::function<Result<void>(std::span<const std::uint8_t>)>& add, std::size_t mostBytes) {
    std::map<int, std::size_t> last;  // the last picture that shows a frame
    for (std::size_t picture = 0; picture < frames.size(); ++picture) last[frames[picture]] = picture;
    KeptFrames kept(mostBytes);
    MoviePicture shown;
    for (std::size_t picture = 0; picture < frames.size(); ++picture) {
        const int frame = frames[picture];
        if (picture == 0 || frame != frames[picture - 1]) {
            shown = kept.find(frame);
            if (shown.empty()) {
                auto made = make(frame);
                if (!made) return tl::unexpected<Failure>(made.error());
                shown = *std::move(made);
                std::size_t run = picture;  // the last picture that shows the frame before another one comes
                while (run + 1 < frames.size() && frames[run + 1] == frame) ++run;
                if (last[frame] > run) kept.keep(frame, shown);
            }
        }
        if (auto added = add(shown); !added) return added;
    }
    return {};
}

}  // namespace echolucent
