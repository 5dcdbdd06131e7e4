package org.palpate.rigid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.body.RandomSolids;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.Phantom;

/** Scenes, tools and hostile poses for tests of rigid tools. */
final class ToolScenes {
  private ToolScenes() {}

  /** Returns a scene of one phantom with unit voxels in the world's axes. */
  static BodyScene phantom(String spec) {
    BitCube bits = Phantom.parse(spec).segments().segments().get(0).bits();
    return new BodyScene(List.of(unit("phantom", bits)));
  }

  /** Returns a body of unit voxels in the world's axes. */
  static Body unit(String name, BitCube bits) {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(bits.sizeX(), bits.sizeY(), bits.sizeZ());
    return new Body(name, bits, grid, Mobility.FIXED);
  }

  /** Returns a scene of some cluttered bodies about the origin, at odd rotations and spacings. */
  static BodyScene clutter(SplittableRandom random, int bodies) {
    List<Body> list = new ArrayList<>();
    for (int n = 0; n < bodies; n++) {
      BitCube bits =
          RandomSolids.clutter(
              random, random.nextInt(9, 30), random.nextInt(9, 30), random.nextInt(9, 30));
      Vec3 spacing = new Vec3(1, 1, 1);
      if (n % 2 == 1) {
        spacing.set(random.nextInt(3), 5);
      }
      Body body = new Body("body" + n, bits, obliqueGrid(bits, spacing), Mobility.FIXED);
      body.setPose(n == 0 ? new Pose() : RandomGeometry.pose(random, 10));
      list.add(body);
    }
    return new BodyScene(list);
  }

  /** Returns a grid with oblique axes. */
  static VoxelGrid obliqueGrid(BitCube bits, Vec3 spacing) {
    RigidTransform axes =
        new RigidTransform(
            new Vec3(0, 0.6, 0.8), new Vec3(1, 0, 0), new Vec3(0, 0.8, -0.6), new Vec3(-9, -9, 2));
    return new VoxelGrid(bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacing, axes);
  }

  /** Returns a block in which every voxel is solid. */
  static BitCube block(int sizeX, int sizeY, int sizeZ) {
    BitCube bits = new BitCube(sizeX, sizeY, sizeZ);
    for (int n = 0; n < sizeX * sizeY * sizeZ; n++) {
      bits.set(n % sizeX, n / sizeX % sizeY, n / (sizeX * sizeY));
    }
    return bits;
  }

  /** Returns the verifier of a tool among bodies that stand still. */
  static MoverVerifier verifier(
      BodyScene scene, RigidTool tool, Clearance[] clearances, boolean skips) {
    RigidSettings settings = new RigidSettings(1, List.of(clearances), List.of(), skips);
    RigidScene rigid = new RigidScene(scene, tool, MovableShapes.none(scene), settings);
    return rigid.verifier(rigid.toolIndex());
  }

  /** Whether the points of a tool with an extent cover its surface. */
  static boolean hasCoveredSurface(RigidTool tool) {
    return tool.coverRadiusMm() > 0 && tool.isCovered();
  }

  /** Returns a tool of one of several kinds. */
  static RigidTool tool(SplittableRandom random) {
    return switch (random.nextInt(5)) {
      case 0 -> ToolSampler.point();
      case 1 -> ToolSampler.ofShape(RodShape.sphere(random.nextDouble(1, 5)), 0.8);
      case 2 -> ToolSampler.ofShape(RodShape.needle(1, 12), 0.7);
      case 3 -> ToolSampler.ofShape(new BoxShape(4, 7, 3), 0.8).thinned(20);
      default -> {
        BitCube bits = RandomSolids.clutter(random, 8, 9, 7);
        yield ToolSampler.ofSegment(bits, VoxelGrid.ofUnitVoxels(8, 9, 7));
      }
    };
  }
}
