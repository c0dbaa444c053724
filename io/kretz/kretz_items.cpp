#include "io/kretz/kretz_items.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <fmt/format.h>

#include "io/files/input_problems.h"
#include "io/voxels/voxel_types.h"

namespace echolucent {

namespace {

constexpr std::uint64_t headerBytes = 8;

std::uint64_t littleEndian(std::span<const std::uint8_t> bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
    return value;
}

std::vector<double> numbersIn(const std::vector<std::uint8_t>& bytes) {
    std::vector<double> numbers(bytes.size() / sizeof(double));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
    return numbers;
}

}  // namespace

KretzSource kretzSource(const InputFile& file) {
    return {file.path(), "", file.size(),
            [file](std::uint64_t offset, std::span<std::uint8_t> bytes) { return file.readAt(offset, bytes); }};
}

tl::unexpected<Failure> KretzItems::refused(KretzTag tag, const std::string& problem, const std::string& remedy) const {
    return fail(FailureKind::unreadable, m_source.path, tagText(tag), problem, remedy);
}

Result<KretzItems> KretzItems::walk(KretzSource source, const Progress& progress) {
    KretzItems items(std::move(source));
    const KretzSource& bytes = items.m_source;
    std::array<std::uint8_t, kretzSignature.size()> signature{};
    if (bytes.size >= signature.size())
        if (auto read = bytes.read(0, signature); !read) return tl::unexpected(read.error());
    if (std::memcmp(signature.data(), kretzSignature.data(), signature.size()) != 0)
        return fail(FailureKind::unreadable, bytes.path, bytes.element, "is no GE Voluson volume (KRETZFILE 1.0)",
                    copyAgain);
    std::uint64_t offset = signature.size();
    while (offset < bytes.size) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, bytes.path, "", "was not read: cancelled");
        std::array<std::uint8_t, headerBytes> header{};
        const std::uint64_t rest = bytes.size - offset;
        const std::span part(header.data(), static_cast<std::size_t>(std::min(rest, headerBytes)));
        if (auto read = bytes.read(offset, part); !read) return tl::unexpected(read.error());
        if (rest < headerBytes) {
            // A DICOM element is padded with zeros.
            if (std::all_of(part.begin(), part.end(), [](std::uint8_t byte) { return byte == 0; })) break;
            return fail(FailureKind::unreadable, bytes.path, bytes.element,
                        fmt::format("ends within the header of an item, at byte {}", offset), incompleteFile);
        }
        const std::span<const std::uint8_t> all(header);
        const KretzItem item{{static_cast<std::uint16_t>(littleEndian(all.subspan(0, 2))),
                              static_cast<std::uint16_t>(littleEndian(all.subspan(2, 2)))},
                             offset + headerBytes,
                             littleEndian(all.subspan(4, 4))};
        if (item.tag == kretz::end) {
            items.m_ended = true;
            break;
        }
        if (item.length > rest - headerBytes)
            return items.refused(item.tag,
                                 fmt::format("at byte {} declares {} bytes where only {} follow", offset, item.length,
                                             rest - headerBytes),
                                 damagedFile);
        if (items.m_items.size() == mostKretzItems)
            return fail(FailureKind::unreadable, bytes.path, bytes.element,
                        fmt::format("has more than {} items, which no scanner writes", mostKretzItems), copyAgain);
        items.m_items.push_back(item);
        offset = item.offset + item.length;
    }
    return items;
}

std::vector<KretzItem> KretzItems::allOf(KretzTag tag) const {
    std::vector<KretzItem> found;
    std::copy_if(m_items.begin(), m_items.end(), std::back_inserter(found),
                 [&](const KretzItem& item) { return item.tag == tag; });
    return found;
}

Result<std::optional<std::vector<std::uint8_t>>> KretzItems::value(KretzTag tag, std::uint64_t length,
                                                                   const std::string& what) const {
    const auto found = allOf(tag);
    if (found.empty()) return std::optional<std::vector<std::uint8_t>>();
    if (found.size() > 1) return refused(tag, fmt::format("stands {} times, and must stand once", found.size()));
    if (found[0].length != length)
        return refused(tag, fmt::format("holds {} bytes, where {} take{} {}", found[0].length, what,
                                        what.starts_with("a ") ? "s" : "", length));
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(length));
    if (auto read = m_source.read(found[0].offset, bytes); !read) return tl::unexpected(read.error());
    return std::optional(std::move(bytes));
}

Result<std::optional<std::int64_t>> KretzItems::wholeNumber(KretzTag tag) const {
    const auto bytes = value(tag, 2, "a whole number");
    if (!bytes) return tl::unexpected(bytes.error());
    if (!*bytes) return std::optional<std::int64_t>();
    return std::optional(static_cast<std::int64_t>(littleEndian(**bytes)));
}

Result<std::optional<double>> KretzItems::number(KretzTag tag) const {
    const auto bytes = value(tag, sizeof(double), "a number");
    if (!bytes) return tl::unexpected(bytes.error());
    if (!*bytes) return std::optional<double>();
    return std::optional(numbersIn(**bytes).front());
}

Result<std::optional<std::vector<double>>> KretzItems::numbers(KretzTag tag, std::int64_t count,
                                                               const std::string& what) const {
    const auto bytes = value(tag, static_cast<std::uint64_t>(count) * sizeof(double), what);
    if (!bytes) return tl::unexpected(bytes.error());
    if (!*bytes) return std::optional<std::vector<double>>();
    return std::optional(numbersIn(**bytes));
}

}  // namespace echolucent
