// The parts every command of echolucent-cli shares.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

#include "io/study.h"
#include "processing/adaptive_otf.h"
#include "processing/result.h"
#include "processing/viewpoint.h"

namespace echolucent::cli {

/// Exit statuses: 0 done, 2 wrong usage, 3 an input could not be read, 4 an output could not be written.
[[nodiscard]] int exitStatus(const Failure& failure);

/// What a command does once its options are parsed; a failure becomes one sentence on stderr and an exit status.
using Action = std::function<Result<void>()>;

/// Each adds one subcommand with its options, help and example, and sets `action` when it was chosen.
void addInfoCommand(CLI::App& program, Action& action);
void addOtfCommand(CLI::App& program, Action& action);
void addRenderCommand(CLI::App& program, Action& action);
void addPhantomCommand(CLI::App& program, Action& action);
void addBenchCommand(CLI::App& program, Action& action);
void addStudyCommand(CLI::App& program, Action& action);
void addSweepCommand(CLI::App& program, Action& action);

/// Options of commands that read a volume: VOLUME, --phase, raw layout, --frames-as-slices, --all-voxels.
struct VolumeOptions {
    std::string path;
    int phase = 0;
    ReadOptions read;
    std::string rawSize, rawSpacing, rawType, rawByteOrder;
    std::int64_t rawHeaderBytes = 0;

    void addTo(CLI::App& command);
    /// Reads the study; fails (wrong usage) where --phase is out of range.
    [[nodiscard]] Result<Study> readAll() const;
    /// Reads and picks the phase.
    [[nodiscard]] Result<std::shared_ptr<const Volume>> readPhase() const;
};

/// --beam-axis, --view-azimuth, --view-elevation, --near.
struct ViewOptions {
    Viewpoint view;
    std::string beamAxis = "+z";
    std::string near = "0";
    void addTo(CLI::App& command);
    [[nodiscard]] bool nearCutSuggested() const { return near == "auto"; }
    /// The view; uncut where the near cut is to be suggested. Fails (wrong usage) where an option is out of range.
    [[nodiscard]] Result<Viewpoint> get() const;
    /// The view of a volume, the near cut suggested where that was asked for (and said on stderr).
    [[nodiscard]] Result<Viewpoint> get(const Volume& volume, const AdaptiveOtfConfig& config) const;
};

/// The method's options: --reading, --initial, --tube-grid, --tube-spacing, --cell-size, --strength, --opacity-scale,
/// ... The reading sets everything; an option overrides it where it stands on the command line.
struct MethodOptions {
    AdaptiveOtfConfig config;  ///< what the options were set to; get() says what holds
    std::string reading = "default";
    std::string initial = "parabolic";
    std::string tubeGrid;
    std::optional<double> opacityScale;
    /// The options must stay where they are from here to get().
    void addTo(CLI::App& command);
    [[nodiscard]] Result<AdaptiveOtfConfig> get() const;

private:
    /// Takes one field over from `given` where its option stands on the command line.
    using Override = std::function<void(const AdaptiveOtfConfig& given, AdaptiveOtfConfig& chosen)>;
    std::vector<Override> m_overrides;
    const CLI::Option* m_initialOption = nullptr;
    template <typename Value>
    void addField(CLI::App& command, const char* option, Value AdaptiveOtfConfig::*field, const char* type,
                  const char* help);
    template <typename Value, typename Names>
    void addChoice(CLI::App& command, const char* option, Value AdaptiveOtfConfig::*field, const Names& names,
                   const char* help);
    void addReading(CLI::App& command);
    void addCurveAndGrid(CLI::App& command);
    void addDetection(CLI::App& command);
    void addScaleSpace(CLI::App& command);
};

/// "AxB" or "AxBxC" (also with commas) into numbers; fails with `option` named.
[[nodiscard]] Result<std::vector<double>> parseNumbers(const std::string& text, std::size_t count,
                                                       const std::string& option);

/// Fails (wrong usage) where two of the paths name the same file; empty paths and "-" are left out.
[[nodiscard]] Result<void> differentFiles(const std::vector<std::string>& paths);

/// linear | parabolic | quartic | manual:FILE. opacityScale multiplies (none: the default of docs/cli.md).
[[nodiscard]] Result<OpacityCurve> curveFromName(const std::string& name, std::optional<double> opacityScale);

}  // namespace echolucent::cli
