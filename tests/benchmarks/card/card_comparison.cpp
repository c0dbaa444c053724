#include "tests/benchmarks/card/card_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "processing/card_picture/card_pictures.h"
#include "processing/ray_caster/light_source.h"
#include "processing/ray_caster/plain/plain_caster.h"
#include "processing/ray_caster/ray_caster.h"

namespace echolucent::bench {

namespace {

/// Side by side: processor, card, and eight times their difference around grey; a portable pixmap.
void write(const std::string& path, const Picture& processor, const Picture& card) {
    const auto one = overBackground(processor, {0, 0, 0}), other = overBackground(card, {0, 0, 0});
    const auto row = 3 * static_cast<std::size_t>(processor.width);
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << 3 * processor.width << ' ' << processor.height << "\n255\n";
    for (std::size_t y = 0; y < static_cast<std::size_t>(processor.height); ++y) {
        file.write(reinterpret_cast<const char*>(&one[y * row]), static_cast<std::streamsize>(row));
        file.write(reinterpret_cast<const char*>(&other[y * row]), static_cast<std::streamsize>(row));
        for (std::size_t i = y * row; i < (y + 1) * row; ++i)
            file.put(static_cast<char>(std::clamp(128 + 8 * (other[i] - one[i]), 0, 255)));
    }
}

/// With the light of castRays() on steps that add little.
Picture castPlainly(const CardCase& one, const RayCastSettings& settings) {
    PlainCasting casting;
    casting.leastLitOpacity = ray_casting::LightSource::worthGradient * std::min(1.0, settings.step);
    return castRaysPlainly(*one.voxels, one.classification, settings, casting).value();
}

std::string fileNameOf(const CardCase& one, CardReading reading) {
    std::string name = one.volume + "-" + one.look + (reading == CardReading::filter ? "-filter" : "-eight") + ".ppm";
    for (char& letter : name)
        if (letter == ' ' || letter == ',' || letter == '/') letter = '_';
    return name;
}

}  // namespace

CardDifference cardDifference(const Picture& card, const Picture& processor) {
    CardDifference found;
    double squares = 0.0;
    int shown = 0;
    for (std::size_t pixel = 0; pixel < processor.rgba.size() / 4; ++pixel) {
        if (processor.rgba[4 * pixel + 3] > 0.0f || card.rgba[4 * pixel + 3] > 0.0f) {
            ++shown;
            for (std::size_t i = 4 * pixel; i < 4 * pixel + 3; ++i) {
                const double levels =
                    255.0 * std::abs(static_cast<double>(card.rgba[i]) - static_cast<double>(processor.rgba[i]));
                squares += levels * levels;
                found.largest = std::max(found.largest, std::isfinite(levels) ? levels : 1e9);
            }
        }
    }
    found.rmse = std::sqrt(squares / std::max(1, 3 * shown));
    return found;
}

bool compareCases(CardWindow& window, const std::vector<CardCase>& cases, const ComparisonPlan& plan) {
    fmt::print("| volume | look | filter: RMSE | largest | eight fetches: RMSE | largest |\n");
    fmt::print("| --- | --- | --- | --- | --- | --- |\n");
    struct Worst {
        double rmse = 0.0;
        std::string name;
    } worst[2];
    std::shared_ptr<const Volume> volume;
    std::optional<RayCaster> caster;
    std::optional<CardPictures> maker;
    for (const CardCase& one : cases) {
        if (volume != one.voxels) {
            volume = one.voxels;
            caster.emplace(volume);
            maker.emplace(volume);
        }
        CardDifference most[2];
        for (int view = 0; view < plan.views; ++view) {
            RayCastSettings settings = one.settings;
            settings.camera =
                cameraAround(*volume, view, plan.views, static_cast<double>(settings.width) / settings.height);
            const Picture processor = plan.plainly
                                          ? castPlainly(one, settings)
                                          : RayCaster(caster->sharing()).cast(one.classification, settings).value();
            const auto picture = std::make_shared<const CardPicture>(maker->make(one.classification, settings).value());
            for (const CardReading reading : {CardReading::filter, CardReading::eightFetches}) {
                window.renderer().setReading(reading);
                if (!window.draw(picture)) {
                    fmt::print(stderr, "{}\n", window.renderer().failure());
                    return false;
                }
                const Picture card = window.renderer().read();
                const CardDifference found = cardDifference(card, processor);
                CardDifference& so = most[reading == CardReading::filter ? 0 : 1];
                if (found.rmse > so.rmse && !plan.pictures.empty())
                    write(plan.pictures + "/" + fileNameOf(one, reading), processor, card);
                so = {std::max(so.rmse, found.rmse), std::max(so.largest, found.largest)};
            }
        }
        fmt::print("| {} | {} |", one.volume, one.look);
        for (int i = 0; i < 2; ++i) {
            fmt::print(" {:.2f} | {:.0f} |", most[i].rmse, most[i].largest);
            if (most[i].rmse > worst[i].rmse) worst[i] = {most[i].rmse, one.volume + ", " + one.look};
        }
        fmt::print("\n");
        std::fflush(stdout);
    }
    fmt::print("\nThe largest RMSE is {:.2f} with the filter ({}) and {:.2f} with eight fetches ({}).\n", worst[0].rmse,
               worst[0].name, worst[1].rmse, worst[1].name);
    return true;
}

}  // namespace echolucent::bench
