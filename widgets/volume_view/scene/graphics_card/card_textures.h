// The textures of a picture on the card. What stays from one picture to the next is not brought there again.
#pragma once

#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>

#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "processing/card_picture/card_picture.h"

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

namespace echolucent {

/// Voxels, presence and gradients of several volumes stay on the card, the newest first, up to a number of bytes: the
/// phases of a heart that plays are brought there once. Of all else only the newest stays.
class CardTextures {
public:
    /// Brings to the card what it lacks of a picture. False if the card takes a texture of that size at no time.
    [[nodiscard]] bool bring(vtkOpenGLRenderWindow& window, const CardPicture& picture);
    /// Tells the program where the picture's textures are. They stay bound until unbind().
    void bind(const CardPicture& picture, vtkShaderProgram& program);
    void unbind();
    void release(vtkWindow* window);

    /// The most bytes of volumes that no longer are in the picture.
    void setKeptBytes(std::int64_t bytes) { m_mostBytes = bytes; }
    /// How often a volume's voxels were brought to the card.
    [[nodiscard]] int volumesBrought() const { return m_volumesBrought; }

private:
    struct Texture {
        /// The part of a picture that the texture holds. It may be freed: a texture keeps nothing in memory.
        std::weak_ptr<const void> from;
        std::int64_t bytes = 0;
        vtkSmartPointer<vtkTextureObject> texture;
    };
    struct Uploading;
    Texture* find(const std::shared_ptr<const void>& from);
    bool keep(vtkOpenGLRenderWindow& window, const std::shared_ptr<const void>& from, const Uploading& uploading);
    bool renew(vtkOpenGLRenderWindow& window, Texture& texture, const std::shared_ptr<const void>& from,
               const Uploading& uploading);
    /// Leaves room for `coming` bytes more.
    void dropOldest(vtkOpenGLRenderWindow& window, std::size_t inUse, std::int64_t coming = 0);
    void bindOne(vtkShaderProgram& program, const char* name, Texture& texture);

    std::list<Texture> m_volumes;  ///< the newest first
    Texture m_bricks, m_light, m_table, m_nodes, m_surface;
    std::vector<vtkTextureObject*> m_bound;
    std::int64_t m_mostBytes = std::int64_t{1} << 30;
    int m_volumesBrought = 0;
};

}  // namespace echolucent
