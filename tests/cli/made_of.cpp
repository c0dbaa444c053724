// What reports say of their making: program, command and study, without folders.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/report/opening_report.h"
#include "io/study/study_checksum.h"
#include "otf_of.h"
#include "program.h"
#include "scan_slices.h"

namespace echolucent {
namespace {

using nlohmann::json;

TEST(MadeOf, SaysWhatItWasMadeOfAndNoFolder) {
    const Folder folder;
    for (const char* name : {"Doe=Jane", "Smith:Anna"}) std::filesystem::create_directory(folder / name);
    const std::string path = folder / "Doe=Jane/scan of a day.mha", curve = folder / "Smith:Anna/c.json";
    std::filesystem::copy_file(shapesFile(), path);
    write(curve, R"({"format": "echolucent-opacity-curve", "version": 1,
        "nodes": [{"intensity": 0.2, "opacity": 0.0}, {"intensity": 0.6, "opacity": 0.4}]})");
    const Outcome outcome = runProgram("otf \"" + path + "\" --near 3 \"--initial=manual:" + curve + "\" --json \"" +
                                       folder / "Smith:Anna/o.json" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const std::string text = contentsOf(folder / "Smith:Anna/o.json");
    for (const std::string& part : {folder / "", std::string("Doe"), std::string("Anna")})
        EXPECT_EQ(text.find(part), std::string::npos) << part;
    const json report = json::parse(text), made = report["made_of"];
    EXPECT_EQ(report["parameters"]["initial"], "manual:c.json");
    EXPECT_TRUE(made["program"].get<std::string>().starts_with("echolucent-cli "));
    EXPECT_EQ(made["command"],
              (json{"otf", "scan of a day.mha", "--near", "3", "--initial=manual:c.json", "--json", "o.json"}));
    EXPECT_EQ(made["study"]["file"], "scan of a day.mha");
    EXPECT_EQ(made["study"]["checksum"], checksumOf({path})->text);
    EXPECT_EQ(made["study"]["series"], "");
    EXPECT_EQ(made["found"]["beam"]["source"], "assumed");
    EXPECT_EQ(made["found"]["reduction"], "medium");
    EXPECT_EQ(cli::withoutFolders("manual:/home/jane/curve.json"), "manual:curve.json");
    EXPECT_EQ(cli::withoutFolders("--json=../out/o.json"), "--json=o.json");
    EXPECT_EQ(cli::withoutFolders("--json=/Doe=Jane/o.json"), "--json=o.json");
    EXPECT_EQ(cli::withoutFolders("--initial=manual:/a/b.json"), "--initial=manual:b.json");
    EXPECT_EQ(cli::withoutFolders("manual:Smith:Anna/Doe=Jane/c.json"), "manual:c.json");
    EXPECT_EQ(cli::withoutFolders("Doe=Jane/v=1:2.mha"), "v=1:2.mha");
    EXPECT_EQ(cli::withoutFolders("--Doe/Jane=1/v.mha"), "v.mha") << "a file's name may begin like an option";
    EXPECT_EQ(cli::withoutFolders("/scans/jane/"), "");
    EXPECT_EQ(cli::withoutFolders("+x"), "+x");
}

TEST(MadeOf, LeavesTheNameOfAStudysFolderOut) {
    const Folder folder;
    std::filesystem::create_directory(folder / "Doe Jane");
    for (int slice = 0; slice < 12; ++slice)
        writeDicom(folder / ("Doe Jane/s" + std::to_string(slice) + ".dcm"), scanSlice(slice));
    for (const std::string& path : {folder / "Doe Jane", folder / "Doe Jane/"}) {
        const json report = otfOf(path);
        EXPECT_EQ(report.dump().find("Jane"), std::string::npos);
        const json& made = report["made_of"];
        EXPECT_EQ(made["command"], (json{"otf", "", "--json", "-", "--reduction", "off"}));
        EXPECT_EQ(made["study"]["file"], "");
        EXPECT_EQ(made["study"]["files"], 12);
        EXPECT_NE(made["study"]["series"], "");
    }
}

TEST(MadeOf, ANameInAnotherEncodingIsReadable) {
    const Folder folder;
    std::filesystem::copy_file(shapesFile(), folder / "gr\xfcn.mha");
    for (const std::string command : {"otf", "sweep --from 0 --to 1"}) {
        const Outcome outcome = runProgram(command + " \"" + folder / "gr\xfcn.mha" + "\" --json -");
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        EXPECT_EQ(json::parse(outcome.output)["made_of"]["study"]["file"], "gr\ufffdn.mha");
    }
}

TEST(MadeOf, SaysTheShareOfVoxelsWithoutDataAsANumber) {
    const Folder folder;
    constexpr std::size_t edge = 24, slice = edge * edge;
    writeConstantVolume(folder / "half.mha", edge, 77);
    std::string bytes = contentsOf(folder / "half.mha");
    bytes.replace(bytes.size() - edge * slice, edge / 2 * slice, std::string(edge / 2 * slice, '\0'));
    write(folder / "half.mha", bytes);
    EXPECT_EQ(otfOf(folder / "half.mha")["made_of"]["found"]["no_data"]["share"], 0.5);
}

}  // namespace
}  // namespace echolucent
