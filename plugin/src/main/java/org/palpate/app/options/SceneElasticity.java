package org.palpate.app.options;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.scene.SceneBody;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneFill;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * The elasticity of the bodies of a scene file.
 *
 * @param materials those of elastic bodies and of fills, by name
 * @param fills the voxels of fills by name, which no tool can touch
 */
public record SceneElasticity(Map<String, ElasticMaterial> materials, Map<String, BitCube> fills) {
  /** No elasticity: all bodies are rigid. */
  public static final SceneElasticity NONE = new SceneElasticity(Map.of(), Map.of());

  /** Returns bodies at rest with the fills behind them. A fill leaves out the voxels of bodies. */
  public SegmentedVolume withFills(SegmentedVolume bodies) {
    List<Segment> all = new ArrayList<>(bodies.segments());
    fills.forEach(
        (name, voxels) -> {
          BitCube left = without(voxels, bodies.segments());
          all.add(new Segment(name, left, SegmentBuilder.paletteColour(all.size())));
        });
    return fills.isEmpty() ? bodies : new SegmentedVolume(bodies.grid(), all);
  }

  private static BitCube without(BitCube voxels, List<Segment> bodies) {
    BitCube left = voxels.copy();
    for (int z = 0; z < left.bricksZ(); z++) {
      for (int y = 0; y < left.bricksY(); y++) {
        for (int x = 0; x < left.bricksX(); x++) {
          long word = left.brick(x, y, z);
          for (Segment body : bodies) {
            word &= ~body.bits().brick(x, y, z);
          }
          left.setBrick(x, y, z, word);
        }
      }
    }
    return left;
  }

  /**
   * Returns a scene whose bodies have this elasticity.
   *
   * @param volume the volume that {@link #withFills} was written to, as the scene names it
   */
  public SceneFile of(SceneFile scene, String volume) {
    List<SceneBody> bodies = new ArrayList<>();
    for (SceneBody body : scene.bodies()) {
      ElasticMaterial material = materials.get(body.name());
      bodies.add(
          material == null ? body : body.elastic(material.youngPascal(), material.poisson()));
    }
    List<SceneFill> written = new ArrayList<>();
    for (String name : fills.keySet()) {
      ElasticMaterial material = materials.get(name);
      int label = bodies.size() + written.size() + 1;
      written.add(
          SceneFill.ofLabel(name, volume, label, material.youngPascal(), material.poisson()));
    }
    return scene.with(bodies, written);
  }
}
