package org.palpate.scene.surface;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

class SurfaceBuilderTest {
  private static final long PATIENCE_MS = 60_000;

  private static final SurfaceBuilder.Sink FULL =
      (brick, order, mesh) -> {
        throw new IllegalStateException("sink is full");
      };

  private final Random random = new Random(Shapes.seed());

  @Test
  void severalThreadsBuildTheSameBricksAsOne() throws Exception {
    SurfaceSource source = SurfaceSource.ofBits(blobs(), Shapes.UNIT);
    assertSameBricks(buildAll(source, 1), buildAll(source, 4));
  }

  /** Compares with the plain way: every brick is extracted anew. */
  @Test
  void patchedBricksHaveTheBitsOfAFullBuild() throws Exception {
    BitCube bits = blobs();
    Vec3 spacing = new Vec3(1, 0.75, 2);
    AmbientOcclusion light = new DensityAmbientOcclusion(List.of(bits.copy()));
    GreyEdgeCrossings.Values values = (i, j, k) -> (31 * i + 57 * j + 97 * k) % 64;
    List<SurfaceSource> sources =
        List.of(
            SurfaceSource.ofBits(bits, spacing),
            new SurfaceSource(bits, new GreyEdgeCrossings(values, 30, 100), spacing, 1));
    for (SurfaceSource source : sources) {
      MapStore store = new MapStore(buildAll(source, light, 2));
      try (SurfaceBuilder builder = new SurfaceBuilder(2)) {
        for (int n = 0; n < 12; n++) {
          builder
              .rebuild(source, light, SurfaceBuilder.Kind.EDITED, edit(bits), store, () -> {})
              .await(PATIENCE_MS);
          assertSameBricks(buildAll(source, light, 2), store.bricks());
        }
      }
    }
  }

  /** Keeps the bricks of one source. */
  private record MapStore(Map<Integer, SurfaceBrick> bricks) implements SurfaceBuilder.Store {
    @Override
    public void accept(int brick, long started, SurfaceBrick mesh) {
      put(bricks, brick, mesh);
    }

    @Override
    public Optional<SurfaceBrick> newest(int brick) {
      return Optional.of(bricks.getOrDefault(brick, SurfaceBrick.EMPTY));
    }
  }

  /** Gives bricks away, so that each rebuild extracts them as a whole. */
  private record NoStore(SurfaceBuilder.Sink sink) implements SurfaceBuilder.Store {
    @Override
    public void accept(int brick, long started, SurfaceBrick mesh) {
      sink.accept(brick, started, mesh);
    }

    @Override
    public Optional<SurfaceBrick> newest(int brick) {
      return Optional.empty();
    }
  }

  @Test
  void editsThatAreFasterThanTheExtractionMakeNoQueue() throws Exception {
    BitCube bits = Shapes.sphere(20, 5);
    SurfaceSource source = SurfaceSource.ofBits(bits, Shapes.UNIT);
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch mayEnd = new CountDownLatch(1);
    List<SurfaceBrick> extracted = new CopyOnWriteArrayList<>();
    AtomicInteger done = new AtomicInteger();
    SurfaceBuilder.Sink sink =
        (brick, order, mesh) -> {
          extracted.add(mesh);
          begun.countDown();
          awaitUnchecked(mayEnd);
        };
    try (SurfaceBuilder builder = new SurfaceBuilder(1)) {
      List<SurfaceJob> jobs = new ArrayList<>();
      for (int n = 0; n < 20; n++) {
        bits.clear(10, 10, 14 - n % 5);
        jobs.add(rebuild(builder, source, sink, done::incrementAndGet));
        assertTrue(begun.await(PATIENCE_MS, TimeUnit.MILLISECONDS)); // the others wait for it
      }
      mayEnd.countDown();
      for (SurfaceJob job : jobs) {
        job.await(PATIENCE_MS);
      }
    }
    assertEquals(2, extracted.size());
    assertEquals(20, done.get());
    SurfaceBrick now = new SurfaceExtractor().extract(source, AmbientOcclusion.NONE, 0);
    assertEquals(now.triangleCount(), extracted.get(1).triangleCount());
  }

  @Test
  void aBrickThatWaitsToBeBuiltIsExtractedOnceForItselfAndItsEdits() throws Exception {
    CountDownLatch mayEnd = new CountDownLatch(1);
    BitCube bits = Shapes.sphere(20, 6);
    SurfaceSource source = SurfaceSource.ofBits(bits, Shapes.UNIT);
    SurfaceSource other = SurfaceSource.ofBits(Shapes.sphere(20, 5), Shapes.UNIT);
    List<SurfaceBrick> extracted = new CopyOnWriteArrayList<>();
    SurfaceBuilder.Sink sink = (brick, order, mesh) -> extracted.add(mesh);
    try (SurfaceBuilder builder = new SurfaceBuilder(1)) {
      builder.build(
          other,
          AmbientOcclusion.NONE,
          SurfaceBuilder.Kind.COARSE,
          (brick, order, mesh) -> awaitUnchecked(mayEnd),
          () -> {});
      SurfaceJob build =
          builder.build(source, AmbientOcclusion.NONE, SurfaceBuilder.Kind.FINE, sink, () -> {});
      bits.clear(10, 10, 15);
      SurfaceJob edit = rebuild(builder, source, sink, () -> {});
      mayEnd.countDown();
      build.await(PATIENCE_MS);
      edit.await(PATIENCE_MS);
    }
    assertEquals(1, extracted.size());
    SurfaceBrick now = new SurfaceExtractor().extract(source, AmbientOcclusion.NONE, 0);
    assertArrayEquals(now.positionsMm(), extracted.get(0).positionsMm());
  }

  @Test
  void editsWithoutAPauseTakeTurnsWithBricksThatAreBuilt() throws Exception {
    SurfaceSource edited = SurfaceSource.ofBits(Shapes.sphere(20, 5), Shapes.UNIT);
    SurfaceSource built = SurfaceSource.ofBits(blobs(), Shapes.UNIT);
    int bricks = BrickLayout.of(built.bits(), SurfaceExtractor.BRICK_EDGE).count();
    AtomicInteger edits = new AtomicInteger();
    AtomicInteger editsAtTheEnd = new AtomicInteger();
    try (SurfaceBuilder builder = new SurfaceBuilder(1)) {
      SurfaceBuilder.Sink[] again = new SurfaceBuilder.Sink[1];
      again[0] =
          (brick, order, mesh) -> {
            if (edits.incrementAndGet() < 10 * bricks) {
              rebuild(builder, edited, again[0], () -> {});
            }
          };
      rebuild(builder, edited, again[0], () -> {});
      builder
          .build(
              built,
              AmbientOcclusion.NONE,
              SurfaceBuilder.Kind.FINE,
              (brick, begun, mesh) -> {},
              () -> editsAtTheEnd.set(edits.get()))
          .await(PATIENCE_MS);
    }
    assertTrue(editsAtTheEnd.get() < 3 * bricks, editsAtTheEnd + " edits, " + bricks + " bricks");
  }

  @Test
  void everyJobThatWaitsForABrickHearsThatItFailed() throws Exception {
    SurfaceSource source = SurfaceSource.ofBits(Shapes.sphere(20, 5), Shapes.UNIT);
    CountDownLatch mayEnd = new CountDownLatch(1);
    try (SurfaceBuilder builder = new SurfaceBuilder(1)) {
      SurfaceJob first =
          rebuild(builder, source, (brick, order, mesh) -> awaitUnchecked(mayEnd), () -> {});
      SurfaceSource other = SurfaceSource.ofBits(Shapes.sphere(20, 6), Shapes.UNIT);
      SurfaceJob second = rebuild(builder, other, FULL, () -> {});
      SurfaceJob third = rebuild(builder, other, FULL, () -> {});
      mayEnd.countDown();
      first.await(PATIENCE_MS);
      assertThrows(IllegalStateException.class, () -> second.await(PATIENCE_MS));
      assertThrows(IllegalStateException.class, () -> third.await(PATIENCE_MS));
    }
  }

  private static SurfaceJob rebuild(
      SurfaceBuilder builder, SurfaceSource source, SurfaceBuilder.Sink sink, Runnable whenDone) {
    IntBox middle = new IntBox();
    middle.include(10, 10, 10);
    return rebuild(builder, source, middle, new NoStore(sink), whenDone);
  }

  private static SurfaceJob rebuild(
      SurfaceBuilder builder,
      SurfaceSource source,
      IntBox edited,
      SurfaceBuilder.Store store,
      Runnable whenDone) {
    return builder.rebuild(
        source, AmbientOcclusion.NONE, SurfaceBuilder.Kind.EDITED, edited, store, whenDone);
  }

  /** The failed edit touches several bricks. The edits after it touch all of them elsewhere. */
  @Test
  void theNextEditRepairsBricksWhoseEditFailed() throws Exception {
    AtomicBoolean fails = new AtomicBoolean();
    BitCube bits = Shapes.sphere(50, 15);
    GreyEdgeCrossings.Values values =
        (i, j, k) -> {
          if (fails.get()) {
            throw new IllegalStateException("no value");
          }
          return (31 * i + 57 * j + 97 * k) % 64;
        };
    SurfaceSource source =
        new SurfaceSource(bits, new GreyEdgeCrossings(values, 30, 100), Shapes.UNIT, 1);
    MapStore store = new MapStore(buildAll(source, 1));
    try (SurfaceBuilder builder = new SurfaceBuilder(1)) {
      fails.set(true);
      SurfaceJob failed = clear(builder, source, store, 25, 25, 39);
      assertThrows(IllegalStateException.class, () -> failed.await(PATIENCE_MS));
      fails.set(false);
      clear(builder, source, store, 25, 25, 11).await(PATIENCE_MS);
      clear(builder, source, store, 43, 43, 43).await(PATIENCE_MS);
    }
    assertSameBricks(buildAll(source, 1), store.bricks());
  }

  private static SurfaceJob clear(
      SurfaceBuilder builder, SurfaceSource source, SurfaceBuilder.Store store, int... voxel) {
    source.bits().clear(voxel[0], voxel[1], voxel[2]);
    IntBox edited = new IntBox();
    edited.include(voxel[0], voxel[1], voxel[2]);
    return rebuild(builder, source, edited, store, () -> {});
  }

  @Test
  void anEditExtractsABrickThatAFailedBuildLeftOut() throws Exception {
    SurfaceSource source = SurfaceSource.ofBits(blobs(), Shapes.UNIT);
    Map<Integer, SurfaceBrick> bricks = new ConcurrentHashMap<>();
    try (SurfaceBuilder builder = new SurfaceBuilder(1)) {
      SurfaceJob build =
          builder.build(source, AmbientOcclusion.NONE, SurfaceBuilder.Kind.FINE, FULL, () -> {});
      assertThrows(IllegalStateException.class, () -> build.await(PATIENCE_MS));
      IntBox all = new IntBox();
      all.include(0, 0, 0);
      all.include(89, 84, 79);
      NoStore store = new NoStore((brick, order, mesh) -> put(bricks, brick, mesh));
      rebuild(builder, source, all, store, () -> {}).await(PATIENCE_MS);
    }
    assertSameBricks(buildAll(source, 1), bricks);
  }

  private static void awaitUnchecked(CountDownLatch latch) {
    try {
      assertTrue(latch.await(PATIENCE_MS, TimeUnit.MILLISECONDS));
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void aFailingSinkIsReportedToTheWaitingThread() {
    SurfaceSource source = SurfaceSource.ofBits(Shapes.sphere(20, 5), Shapes.UNIT);
    try (SurfaceBuilder builder = new SurfaceBuilder(1)) {
      SurfaceJob build =
          builder.build(source, AmbientOcclusion.NONE, SurfaceBuilder.Kind.FINE, FULL, () -> {});
      Exception failure = assertThrows(IllegalStateException.class, () -> build.await(PATIENCE_MS));
      assertEquals("sink is full", failure.getCause().getMessage());
      assertTrue(build.isDone());
    }
  }

  @Test
  void anUpdatedCoarseVolumeEqualsANewOne() throws Exception {
    BitCube bits = blobs();
    for (int shift = 1; shift <= 2; shift++) {
      CoarseVolume followed = CoarseVolume.of(bits, shift);
      for (int edit = 0; edit < 20; edit++) {
        followed.update(edit(bits));
      }
      assertSameBricks(
          buildAll(CoarseVolume.of(bits, shift).source(Shapes.UNIT), 1),
          buildAll(followed.source(Shapes.UNIT), 1));
    }
  }

  /** Fills or empties a random box, also beyond the grid, and returns it. */
  private IntBox edit(BitCube bits) {
    IntBox box = new IntBox();
    int[] low = random.ints(3, -3, 100).toArray();
    boolean solid = random.nextBoolean();
    for (int n = 0; n < 343; n++) {
      int i = low[0] + n % 7;
      int j = low[1] + n / 7 % 7;
      int k = low[2] + n / 49;
      box.include(i, j, k);
      boolean inside = i >= 0 && j >= 0 && k >= 0;
      if (inside && i < bits.sizeX() && j < bits.sizeY() && k < bits.sizeZ()) {
        set(bits, i, j, k, solid);
      }
    }
    return box;
  }

  private static void set(BitCube bits, int i, int j, int k, boolean solid) {
    if (solid) {
      bits.set(i, j, k);
    } else {
      bits.clear(i, j, k);
    }
  }

  @Test
  void aCoarseSphereHasAboutTheSameVolumeAndFarFewerTriangles() {
    BitCube bits = Shapes.sphere(64, 25);
    WeldedSurface fine = Shapes.surface(SurfaceSource.ofBits(bits, Shapes.UNIT));
    for (int shift = 1; shift <= 2; shift++) {
      WeldedSurface coarse = Shapes.surface(CoarseVolume.of(bits, shift).source(Shapes.UNIT));
      assertEquals(
          1,
          SurfaceMeasures.of(coarse).volumeMm3() / SurfaceMeasures.of(fine).volumeMm3(),
          0.08 * shift,
          "shift " + shift);
      assertTrue(coarse.triangleCount() < fine.triangleCount() / (3 * shift));
    }
  }

  @Test
  void aThinWallDoesNotVanishAtCoarseResolution() {
    BitCube wall = Shapes.cube(40, 40, 40, (x, y, z) -> Math.floor(x) == 17);
    WeldedSurface coarse = Shapes.surface(CoarseVolume.of(wall, 2).source(Shapes.UNIT));
    assertTrue(
        SurfaceMeasures.of(coarse).areaMm2() > 2 * 35 * 35,
        "area " + SurfaceMeasures.of(coarse).areaMm2());
  }

  @Test
  void aHollowHasLessAmbientLightThanTheOutside() {
    BitCube shell =
        Shapes.cube(
            64,
            64,
            64,
            (x, y, z) -> {
              double r =
                  Math.sqrt(Shapes.square(x - 32) + Shapes.square(y - 32) + Shapes.square(z - 32));
              return r > 12 && r < 28;
            });
    DensityAmbientOcclusion openness = new DensityAmbientOcclusion(List.of(shell));
    float outside = openness.at(60, 32, 32, 1, 0, 0);
    float inside = openness.at(44, 32, 32, -1, 0, 0);
    assertTrue(outside > 0.8f, "outside " + outside);
    assertTrue(inside < 0.8f * outside, "inside " + inside);
  }

  private BitCube blobs() {
    BitCube bits = Shapes.random(90, 85, 80, 0.002, random);
    BitCube sphere = Shapes.sphere(80, 30);
    for (int k = 0; k < 80; k++) {
      for (int j = 0; j < 80; j++) {
        for (int i = 0; i < 80; i++) {
          if (sphere.get(i, j, k)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  private static Map<Integer, SurfaceBrick> buildAll(SurfaceSource source, int threads)
      throws Exception {
    return buildAll(source, AmbientOcclusion.NONE, threads);
  }

  private static Map<Integer, SurfaceBrick> buildAll(
      SurfaceSource source, AmbientOcclusion light, int threads) throws Exception {
    Map<Integer, SurfaceBrick> bricks = new ConcurrentHashMap<>();
    try (SurfaceBuilder builder = new SurfaceBuilder(threads)) {
      SurfaceJob build =
          builder.build(
              source,
              light,
              SurfaceBuilder.Kind.FINE,
              (brick, begun, mesh) -> put(bricks, brick, mesh),
              () -> {});
      build.await(PATIENCE_MS);
      assertEquals(1, build.progress());
    }
    return bricks;
  }

  private static void put(Map<Integer, SurfaceBrick> bricks, int brick, SurfaceBrick mesh) {
    if (mesh == null) {
      bricks.remove(brick);
    } else {
      bricks.put(brick, mesh);
    }
  }

  private static void assertSameBricks(
      Map<Integer, SurfaceBrick> expected, Map<Integer, SurfaceBrick> actual) {
    assertEquals(expected.keySet(), actual.keySet());
    expected.forEach(
        (brick, mesh) -> {
          assertArrayEquals(mesh.positionsMm(), actual.get(brick).positionsMm());
          assertArrayEquals(mesh.normals(), actual.get(brick).normals());
          assertArrayEquals(mesh.triangles(), actual.get(brick).triangles());
        });
  }
}
