package org.palpate.scene.window;

import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** A scene of two boxes for tests of pictures. */
final class TwoBoxes {
  /** The edge of the grid, voxels. */
  static final int EDGE = 24;

  static final int BLUE = 0x2040d0;
  private static final int RED = 0xd03020;

  private TwoBoxes() {}

  /** Returns a scene of two boxes, whose surfaces are built. */
  static SceneModel model(WorldAxes axes, RigidTransform pose) throws Exception {
    SceneModel model = new SceneModel(axes, Theme.DARK);
    try (SceneLoader loader = new SceneLoader(model, volume(pose), 1)) {
      loader.await(60_000);
    }
    return model;
  }

  /** Returns two boxes side by side: red at low x, blue at high x. */
  static SegmentedVolume volume(RigidTransform pose) {
    VoxelGrid grid = new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(1, 1, 1), pose);
    return new SegmentedVolume(
        grid, List.of(new Segment("red", box(2), RED), new Segment("blue", box(13), BLUE)));
  }

  private static BitCube box(int fromX) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 4; k < 20; k++) {
      for (int j = 8; j < 16; j++) {
        for (int i = fromX; i < fromX + 9; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }
}
