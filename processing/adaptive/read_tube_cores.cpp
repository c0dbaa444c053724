#include "processing/adaptive/read_tube_cores.h"

#include "processing/tube_core/tube_reader.h"

namespace echolucent {

void readTubeCores(const Volume& volume, std::span<const TubeSamples> samples, int columns, const CellRule& rule,
                   Detection& detection, StageRunner& run) {
    const auto inRow = static_cast<std::size_t>(columns);
    run.forEach(
        samples.size() / inRow, [&] { return TubeReader(volume, rule); },
        [&](std::size_t row, TubeReader& reader) {
            const std::size_t first = row * inRow;
            reader.read(samples.subspan(first, inRow));
            for (std::size_t place = 0; place < inRow; ++place) detection.keep(reader, place, first + place);
        });
}

}  // namespace echolucent
