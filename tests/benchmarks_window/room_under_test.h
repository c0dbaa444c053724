// The review room with all four panes visible, and the hand that drags in it.
#pragma once

#include <array>

#include "tests/benchmarks_window/measures.h"
#include "tests/benchmarks_window/memory.h"
#include "tests/benchmarks_window/open_window.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent::bench {

/// An update is on the screen when every pane that the state is to be seen in shows it; a picture that was there before
/// is none.
class RoomUnderTest : private OpenWindow {
public:
    /// Opens the volume in four panes of edge x edge device pixels.
    RoomUnderTest(const QString& volume, int edge);

    /// All that a study can have at once: quiet voxels, light, the adaptive OTF, the planes in 3D, a render box that
    /// cuts a tenth of each side, a near cut and a stroke of the scalpel.
    void switchEverythingOn();
    /// Right now, at rest.
    [[nodiscard]] Memory memory() const { return memoryNow(); }

    /// Drags the reference point round in plane A. An update: all planes are painted with their lines there, B and C
    /// with voxels that were resampled since the update before, and the 3D view shows the lines, where it shows any.
    [[nodiscard]] Row dragReference(const Amount& amount);
    /// Drags a side of the box in plane A to and fro. An update: all planes are painted with the box there, and a 3D
    /// picture cast since the update before is on the screen.
    [[nodiscard]] Row dragBox(const Amount& amount);
    /// Turns the 3D view. An update: a 3D picture cast since the update before is on the screen; the planes do not
    /// change.
    [[nodiscard]] Row orbit(const Amount& amount);

private:
    enum class Watched { reference, box, camera };
    /// What a pane was last painted with.
    struct Painted {
        Planes planes{};
        std::optional<OrientedBox> box{};
        qint64 image = 0;
        friend bool operator==(const Painted&, const Painted&) = default;
    };
    [[nodiscard]] static Painted presentOf(const PlanePane& pane);
    [[nodiscard]] bool updated(Watched watched) const;
    void beginUpdate();
    /// Moves the hand once more than there are updates, as a hand that does not wait for them.
    Row follow(Watched watched, const Amount& amount, const std::function<void()>& move);
    Row dragInPlane(Watched watched, const QPointF& from, const Amount& amount,
                    const std::function<QPointF(int)>& placeOfMove);
    void send(QEvent::Type type, const QPointF& place);

    std::array<PlanePane*, 3> m_panes{};
    std::array<Painted, 3> m_painted, m_before;  ///< at the last paint, and at that of the update before
    bool m_delivered = false;                    ///< a picture cast since the update before
    bool m_deliveredDrawn = false;               ///< and it is on the screen
    bool m_drawn = false;                        ///< anything was drawn in 3D since the update before
};

}  // namespace echolucent::bench
