package org.palpate.app.options;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
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

  /**
   * Returns this elasticity after edits: fills without the voxels of bodies, and without those
   * fills of which nothing is left, because a scene file refuses them.
   *
   * @param bodies the bodies at rest
   */
  public SceneElasticity leftBy(SegmentedVolume bodies) {
    Map<String, BitCube> left = new LinkedHashMap<>();
    fills.forEach(
        (name, voxels) -> {
          BitCube ofFill = without(voxels, bodies.segments());
          if (ofFill.solidCount() > 0) {
            left.put(name, ofFill);
          }
        });
    return new SceneElasticity(materials, left);
  }

  /** Returns bodies at rest with the fills behind them. */
  public SegmentedVolume withFills(SegmentedVolume bodies) {
    List<Segment> all = new ArrayList<>(bodies.segments());
    fills.forEach(
        (name, voxels) ->
            all.add(new Segment(name, voxels, SegmentBuilder.paletteColour(all.size()))));
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
   * Returns a scene whose bodies have this elasticity. Bodies that have it already stay as they
   * are, and so does the scene if nothing is elastic.
   *
   * @param volume the volume that {@link #withFills} was written to, as the scene names it
   */
  public SceneFile of(SceneFile scene, String volume) {
    if (materials.isEmpty()) {
      return scene;
    }
    List<SceneBody> bodies = new ArrayList<>();
    for (SceneBody body : scene.bodies()) {
      ElasticMaterial material = materials.get(body.name());
      boolean stays = material == null || has(body, material);
      bodies.add(stays ? body : body.elastic(material.youngPascal(), material.poisson()));
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

  private static boolean has(SceneBody body, ElasticMaterial material) {
    return body.youngPa().equals(OptionalDouble.of(material.youngPascal()))
        && body.poisson().orElse(ElasticMaterial.USUAL_POISSON) == material.poisson();
  }
}
