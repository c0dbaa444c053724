// The review room with all four panes visible, and the hand that drags in it.
#pragma once

#include <array>

#include "tests/benchmarks_window/measures.h"
#include "tests/benchmarks_window/memory.h"
#include "tests/benchmarks_window/open_window.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent::bench {

/// An update is on the screen when every pane that the state belongs to shows it. An older picture does not count.
class RoomUnderTest : private OpenWindow {
public:
    /// Opens the volume in four panes of edge x edge device pixels.
    RoomUnderTest(const QString& volume, int edge);

    /// Switches on all that a study can have at once: quiet voxels, light, the adaptive OTF, the planes in 3D, a render
    /// box that cuts a tenth of each side, a near cut and a stroke of the scalpel.
    void switchEverythingOn();
    [[nodiscard]] Memory memory() const { return memoryNow(); }

    /// Drags the reference point round in plane A. An update: all planes are painted with their lines there, B and C
    /// with newly resampled voxels. The 3D view shows the lines if it shows any.
    [[nodiscard]] Row dragReference(const Amount& amount);
    /// Drags a side of the box in plane A to and fro. An update: all planes are painted with the box there, and a newly
    /// cast 3D picture is on the screen.
    [[nodiscard]] Row dragBox(const Amount& amount);
    /// Turns the 3D view. An update: a newly cast 3D picture is on the screen; the planes do not change.
    [[nodiscard]] Row orbit(const Amount& amount);

private:
    enum class Watched { reference, box, camera };
    /// The newest paint of a pane.
    struct Painted {
        Planes planes{};
        std::optional<OrientedBox> box{};
        qint64 image = 0;
        friend bool operator==(const Painted&, const Painted&) = default;
    };
    [[nodiscard]] static Painted presentOf(const PlanePane& pane);
    [[nodiscard]] bool updated(Watched watched) const;
    void beginUpdate();
    /// Moves the hand once more than there are updates: the hand does not wait for them.
    Row follow(Watched watched, const Amount& amount, const std::function<void()>& move);
    Row dragInPlane(Watched watched, const QPointF& from, const Amount& amount,
                    const std::function<QPointF(int)>& placeOfMove);
    void send(QEvent::Type type, const QPointF& place);

    std::array<PlanePane*, 3> m_panes{};
    std::array<Painted, 3> m_painted, m_before;  ///< at the last paint, and at the paint of the update before
    bool m_delivered = false;                    ///< whether a picture was cast since the update before
    bool m_deliveredDrawn = false;               ///< whether that picture is on the screen
    bool m_drawn = false;                        ///< whether anything was drawn in 3D since the update before
};

}  // namespace echolucent::bench
