#include "widgets/volume_view/scene/graphics_card/card_textures.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>

#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"

namespace echolucent {

/// Values for a texture. `depth` is 0 for one of two dimensions.
struct CardTextures::Uploading {
    std::array<std::int64_t, 3> size;
    int components;
    int type;
    const void* values;
    bool filtered;
};

namespace {

std::int64_t bytesOf(const std::array<std::int64_t, 3>& size, int components, int type) {
    const std::int64_t each = type == VTK_FLOAT ? 4 : type == VTK_UNSIGNED_SHORT ? 2 : 1;
    return size[0] * size[1] * std::max<std::int64_t>(size[2], 1) * components * each;
}

bool isFrom(const std::weak_ptr<const void>& one, const std::shared_ptr<const void>& other) {
    return !one.owner_before(other) && !other.owner_before(one);
}

}  // namespace

CardTextures::Texture* CardTextures::find(const std::shared_ptr<const void>& from) {
    for (Texture& texture : m_volumes)
        if (isFrom(texture.from, from)) return &texture;
    return nullptr;
}

bool CardTextures::renew(vtkOpenGLRenderWindow& window, Texture& texture, const std::shared_ptr<const void>& from,
                         const Uploading& uploading) {
    if (texture.texture && isFrom(texture.from, from)) return true;
    if (!texture.texture) texture.texture = vtkSmartPointer<vtkTextureObject>::New();
    vtkTextureObject& object = *texture.texture;
    object.SetContext(&window);
    object.SetWrapS(vtkTextureObject::ClampToEdge);
    object.SetWrapT(vtkTextureObject::ClampToEdge);
    object.SetWrapR(vtkTextureObject::ClampToEdge);
    const int filter = uploading.filtered ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
    object.SetMinificationFilter(filter);
    object.SetMagnificationFilter(filter);
    const auto side = [&](std::size_t axis) { return static_cast<unsigned>(uploading.size[axis]); };
    auto* values = const_cast<void*>(uploading.values);  // VTK's signature is not const, but VTK only reads
    texture.from.reset();
    const bool made =
        uploading.size[2] > 0
            ? object.AllocateProxyTexture3D(side(0), side(1), side(2), uploading.components, uploading.type) &&
                  object.Create3DFromRaw(side(0), side(1), side(2), uploading.components, uploading.type, values)
            : object.Create2DFromRaw(side(0), side(1), uploading.components, uploading.type, values);
    if (!made) return false;
    texture.from = from;
    texture.bytes = bytesOf(uploading.size, uploading.components, uploading.type);
    return true;
}

bool CardTextures::keep(vtkOpenGLRenderWindow& window, const std::shared_ptr<const void>& from,
                        const Uploading& uploading) {
    if (Texture* known = find(from)) {
        for (auto at = m_volumes.begin(); at != m_volumes.end(); ++at)
            if (&*at == known) {
                m_volumes.splice(m_volumes.begin(), m_volumes, at);
                return true;
            }
    }
    return renew(window, m_volumes.emplace_front(), from, uploading);
}

void CardTextures::dropOldest(vtkOpenGLRenderWindow& window, std::size_t inUse, std::int64_t coming) {
    std::int64_t bytes = coming;
    std::size_t count = 0;
    for (auto at = m_volumes.begin(); at != m_volumes.end();) {
        if (count++ >= inUse) bytes += at->bytes;
        if (bytes > m_mostBytes || at->from.expired()) {
            at->texture->ReleaseGraphicsResources(&window);
            at = m_volumes.erase(at);
        } else {
            ++at;
        }
    }
}

bool CardTextures::bring(vtkOpenGLRenderWindow& window, const CardPicture& picture) {
    const Volume& filled = picture.scan->filled;
    const auto& size = filled.geometry().size;
    std::size_t inUse = 1;
    const Uploading voxels = std::visit(
        [&]<typename Voxel>(const VoxelArray<Voxel>& array) {
            const void* values = picture.scan->positions.empty() ? static_cast<const void*>(array.data())
                                                                 : picture.scan->positions.data();
            return Uploading{size, 1, vtkTypeOf<Voxel>(), values, true};
        },
        filled.voxels());
    const bool isNew = find(picture.scan) == nullptr;
    if (isNew) dropOldest(window, 0, bytesOf(voxels.size, voxels.components, voxels.type));
    bool brought = keep(window, picture.scan, voxels);
    if (isNew && brought) ++m_volumesBrought;
    if (brought && picture.presence) {
        const auto& bytes = std::get<VoxelArray<std::uint8_t>>(picture.presence->voxels());
        brought = keep(window, picture.presence, {size, 1, VTK_UNSIGNED_CHAR, bytes.data(), true});
        ++inUse;
    }
    if (brought && picture.gradients) {
        brought = keep(window, picture.gradients, {size, 1, VTK_UNSIGNED_CHAR, picture.gradients->bytes.data(), true});
        ++inUse;
    }
    if (brought && picture.bricks)
        brought = renew(window, m_bricks, picture.bricks,
                        {picture.bricks->size, 1, VTK_UNSIGNED_CHAR, picture.bricks->distances.data(), false});
    if (brought && picture.light) {
        const LightVolume& light = *picture.light;
        brought =
            renew(window, m_light, picture.light,
                  {{light.size[0], light.size[1], light.size[2]}, 2, VTK_UNSIGNED_CHAR, light.reaching.data(), true});
    }
    if (brought && !isFrom(m_table.from, picture.table)) {
        constexpr int entries = ray_casting::TransferTable::intervals + 2;
        std::vector<float> both;
        both.reserve(2 * entries);
        for (int i = 0; i < entries; ++i) {
            both.push_back(picture.table->opacities()[i]);
            both.push_back(picture.table->extinctions()[i]);
        }
        brought = renew(window, m_table, picture.table, {{entries, 1, 0}, 2, VTK_FLOAT, both.data(), false});
    }
    if (brought && picture.gradients) {
        const auto& otf = picture.classification.twoDimensional();
        brought = renew(window, m_nodes, otf,
                        {{otf->intensities, otf->gradients, 0}, 1, VTK_FLOAT, otf->opacities.data(), false});
    }
    if (brought && picture.surface) {
        const CutSurface& surface = *picture.surface;
        brought = renew(window, m_surface, picture.surface,
                        {{surface.columns, surface.rows, 0}, 1, VTK_FLOAT, surface.depthMm.values().data(), false});
    }
    dropOldest(window, inUse);
    return brought;
}

void CardTextures::bindOne(vtkShaderProgram& program, const char* name, Texture& texture) {
    if (!program.IsUniformUsed(name)) return;
    texture.texture->Activate();
    program.SetUniformi(name, texture.texture->GetTextureUnit());
    m_bound.push_back(texture.texture);
}

void CardTextures::bind(const CardPicture& picture, vtkShaderProgram& program) {
    bindOne(program, "voxels", *find(picture.scan));
    if (picture.presence) bindOne(program, "presence", *find(picture.presence));
    if (picture.gradients) {
        bindOne(program, "gradients", *find(picture.gradients));
        bindOne(program, "nodes", m_nodes);
    }
    if (picture.bricks) bindOne(program, "distances", m_bricks);
    if (picture.light) bindOne(program, "reaching", m_light);
    if (picture.surface) bindOne(program, "surface", m_surface);
    bindOne(program, "table", m_table);
}

void CardTextures::unbind() {
    for (vtkTextureObject* texture : m_bound) texture->Deactivate();
    m_bound.clear();
}

void CardTextures::release(vtkWindow* window) {
    m_bound.clear();
    for (Texture& texture : m_volumes) texture.texture->ReleaseGraphicsResources(window);
    m_volumes.clear();
    for (Texture* texture : {&m_bricks, &m_light, &m_table, &m_nodes, &m_surface}) {
        if (texture->texture) texture->texture->ReleaseGraphicsResources(window);
        *texture = {};
    }
}

}  // namespace echolucent
