#include "scene/gltf/meshopt_attributes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

// The libraries of many distributions know version 0 only, so this code follows the specification.

namespace opaline::scene {

namespace {

using Bytes = std::span<const unsigned char>;

constexpr std::size_t groupElements = 16;
constexpr std::size_t mostBlockElements = 256;
constexpr std::size_t mostStride = 256;

/// The deltas of one byte position, for all elements of a block.
using Deltas = std::array<unsigned char, mostBlockElements>;

/// Bits per delta of a group, by the two bits of its header.
using Widths = std::array<unsigned, 4>;
constexpr Widths widthsOfVersion0{0, 2, 4, 8};
constexpr std::array<Widths, 2> widthsOfControl{{{0, 1, 2, 4}, {1, 2, 4, 8}}};

constexpr unsigned allZero = 2;  ///< a control; smaller ones index widthsOfControl
constexpr unsigned literal = 3;

constexpr unsigned ofBytes = 0;  ///< a channel's mode
constexpr unsigned ofPairs = 1;
constexpr unsigned ofWords = 2;

/// Takes bytes from the front. Taking more than is left yields nothing, and is remembered.
class Source {
 public:
  explicit Source(Bytes bytes) : left_(bytes) {}

  Bytes take(std::size_t count) {
    if (count > left_.size()) {
      short_ = true;
      return {};
    }
    const Bytes taken = left_.first(count);
    left_ = left_.subspan(count);
    return taken;
  }
  bool exhausted() const { return short_; }
  bool usedUp() const { return !short_ && left_.empty(); }

 private:
  Bytes left_;
  bool short_ = false;
};

/// A group is packed values, then a whole byte for each value whose bits are all set. Single bits
/// are packed from the lowest bit of a byte, wider ones from the highest.
void readGroup(Source& from, unsigned width, unsigned char* group) {
  if (width == 0) {
    std::fill_n(group, groupElements, static_cast<unsigned char>(0));
    return;
  }
  const Bytes packed = from.take(groupElements * width / 8);
  if (packed.empty()) return;
  if (width == 8) {
    std::copy(packed.begin(), packed.end(), group);
    return;
  }
  const unsigned perByte = 8 / width;
  const unsigned allSet = (1U << width) - 1;
  for (unsigned i = 0; i < groupElements; ++i) {
    const unsigned place = i % perByte;
    const unsigned shift = width * (width == 1 ? place : perByte - 1 - place);
    const unsigned value = (unsigned{packed[i / perByte]} >> shift) & allSet;
    group[i] = static_cast<unsigned char>(value);
    if (value != allSet) continue;
    const Bytes whole = from.take(1);
    if (whole.empty()) return;
    group[i] = whole[0];
  }
}

void readDeltas(Source& from, const Widths& widths, std::size_t elements, Deltas& deltas) {
  const std::size_t groups = (elements + groupElements - 1) / groupElements;
  const Bytes header = from.take((groups + 3) / 4);
  for (std::size_t g = 0; g < groups && !from.exhausted(); ++g) {
    const unsigned bits = (unsigned{header[g / 4]} >> (2 * (g % 4))) & 3U;
    readGroup(from, widths[bits], &deltas[g * groupElements]);
  }
}

void readControlled(Source& from, unsigned control, std::size_t elements, Deltas& deltas) {
  if (control == allZero) {
    deltas.fill(0);
  } else if (control == literal) {
    const Bytes bytes = from.take(elements);
    std::copy(bytes.begin(), bytes.end(), deltas.begin());
  } else {
    readDeltas(from, widthsOfControl[control], elements, deltas);
  }
}

template <typename T>
T withoutZigzag(T value) {
  return static_cast<T>((value & 1U) != 0 ? ~(value >> 1U) : value >> 1U);
}

/// Adds up the deltas of values of type T that begin at one byte of the elements, `stride` apart.
/// `previous` is the element before the first; on return it is the last.
template <typename T, typename Next>
void addUp(const Deltas* deltas, std::size_t count, std::size_t stride, unsigned char* to,
           unsigned char* previous, Next&& next) {
  T value{};
  std::memcpy(&value, previous, sizeof(T));  // little-endian, as is every supported host
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t delta = 0;
    for (std::size_t b = 0; b < sizeof(T); ++b) delta |= std::uint32_t{deltas[b][i]} << (8 * b);
    value = next(value, static_cast<T>(delta));
    std::memcpy(to + i * stride, &value, sizeof(T));
  }
  std::memcpy(previous, &value, sizeof(T));
}

/// Decodes the four bytes of a channel, which share a mode.
void addUpChannel(unsigned char mode, const Deltas* deltas, std::size_t count, std::size_t stride,
                  unsigned char* to, unsigned char* previous) {
  const auto sums = [&]<typename T>(T) {
    for (std::size_t at = 0; at < 4; at += sizeof(T)) {
      addUp<T>(deltas + at, count, stride, to + at, previous + at,
               [](T value, T delta) { return static_cast<T>(value + withoutZigzag(delta)); });
    }
  };
  if (mode == ofBytes) {
    sums(std::uint8_t{});
  } else if (mode == ofPairs) {
    sums(std::uint16_t{});
  } else {
    const int turned = mode >> 4;
    addUp<std::uint32_t>(
        deltas, count, stride, to, previous,
        [&](std::uint32_t value, std::uint32_t delta) { return value ^ std::rotr(delta, turned); });
  }
}

bool isChannelMode(unsigned char mode) {
  return mode == ofBytes || mode == ofPairs || (mode & 15U) == ofWords;
}

}  // namespace

bool decodeMeshoptAttributes(Bytes stream, std::size_t stride, std::span<unsigned char> elements) {
  constexpr unsigned char header = 0xa0;
  if (stream.empty() || stream[0] < header || stream[0] > header + 1) return false;
  const bool version1 = stream[0] == header + 1;
  const std::size_t channels = stride / 4;
  const std::size_t tail = stride + (version1 ? channels : 0);
  const std::size_t padded = std::max<std::size_t>(tail, version1 ? 24 : 32);
  if (stream.size() < 1 + padded) return false;

  std::array<unsigned char, mostStride> previous{};
  const Bytes first = stream.last(tail);
  std::copy_n(first.begin(), stride, previous.begin());
  std::array<unsigned char, mostStride / 4> modes{};
  if (version1)
    std::copy_n(first.begin() + static_cast<std::ptrdiff_t>(stride), channels, modes.begin());
  if (!std::all_of(modes.begin(), modes.end(), isChannelMode)) return false;

  Source from(stream.subspan(1, stream.size() - 1 - padded));
  const std::size_t mostInBlock = std::min(8192 / stride & ~std::size_t{15}, mostBlockElements);
  for (std::size_t done = 0; done < elements.size() / stride;) {
    const std::size_t count = std::min(elements.size() / stride - done, mostInBlock);
    const Bytes controls = from.take(version1 ? channels : 0);
    for (std::size_t c = 0; c < channels && !from.exhausted(); ++c) {
      std::array<Deltas, 4> deltas{};
      for (unsigned b = 0; b < 4; ++b) {
        if (version1) {
          readControlled(from, (unsigned{controls[c]} >> (2 * b)) & 3U, count, deltas[b]);
        } else {
          readDeltas(from, widthsOfVersion0, count, deltas[b]);
        }
      }
      if (from.exhausted()) return false;
      addUpChannel(modes[c], deltas.data(), count, stride, &elements[done * stride + 4 * c],
                   &previous[4 * c]);
    }
    if (from.exhausted()) return false;
    done += count;
  }
  return from.usedUp();
}

}  // namespace opaline::scene
