// 4D studies of small phantoms in the real main window.
#pragma once

#include "io/writers/nifti_writer.h"
#include "tests/app/window_fixture.h"

namespace echolucent {

class CineFixture : public WindowFixture {
public:
    static constexpr int phaseCount = 5;

    CineFixture() { lookAtNoPicture(); }

    void writeStudies() {
        std::vector<std::shared_ptr<const Volume>> phases;
        for (int i = 0; i < phaseCount; ++i)
            phases.push_back(
                smallPhantom(PhantomScene::fetus, static_cast<std::uint64_t>(7 + i), 1.0 * i / phaseCount));
        m_moving = file("moving.mha", phases);
        m_still = file("still.mha", {phases.front()});
        m_timed = temporaryFolder().filePath("timed.nii");
        if (!writeNifti(m_timed.toStdString(), phases, 0.0305)) qFatal("%s", qPrintable(m_timed));
    }
    void showWindow() {
        show();
        useLook(Look{});
    }
    /// A study whose phases have no known length.
    [[nodiscard]] const QString& moving() const { return m_moving; }
    /// The same phases, 30.5 ms each.
    [[nodiscard]] const QString& timed() const { return m_timed; }
    /// The first phase alone.
    [[nodiscard]] const QString& still() const { return m_still; }
    [[nodiscard]] const Document& document() { return window().document().document(); }

private:
    QString m_moving, m_timed, m_still;
};

}  // namespace echolucent
