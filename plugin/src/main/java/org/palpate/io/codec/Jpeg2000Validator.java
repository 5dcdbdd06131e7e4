package org.palpate.io.codec;

import java.io.IOException;

/**
 * Checks a JPEG 2000 codestream before a library decodes it. The library trusts its input: it
 * searches for ever for a missing tile, and two bytes of 0xFF in a packet header, which no encoder
 * writes, are an endless run of ones to it.
 *
 * <p>Source: ITU-T T.800, annex A; B.10.1 and C.2 for the bytes that never occur in coded data.
 */
public final class Jpeg2000Validator {
  private static final int START = 0xFF4F;
  private static final int SIZE = 0xFF51;
  private static final int CODING = 0xFF52;
  private static final int COMPONENT_CODING = 0xFF53;
  private static final int PACKED_HEADS = 0xFF60;
  private static final int PACKED_TILE_HEADS = 0xFF61;
  private static final int TILE_PART = 0xFF90;
  private static final int PACKET = 0xFF91;
  private static final int PACKET_HEAD_END = 0xFF92;
  private static final int TILE_DATA = 0xFF93;
  private static final int END = 0xFFD9;
  private static final int REVERSIBLE = 1;
  private static final int MAX_LEVELS = 32;
  private static final int MAX_LAYERS = 1024;
  private static final int MAX_TILES = 65535;
  private static final int TILE_PART_BYTES = 12;

  /** The largest word that begins with 0xFF in coded data. */
  private static final int MAX_CODED = 0xFF8F;

  /**
   * The smallest precinct that is accepted, as the logarithm of its edge in pixels. Smaller ones
   * make a header longer than its data.
   */
  private static final int MIN_PRECINCT_LOG = 4;

  /** A limit on memory: the library keeps a few numbers for each layer of each code block. */
  private static final long MAX_BLOCK_LAYERS = 1 << 22;

  private final byte[] bytes;
  private final int columns;
  private final int rows;
  private int tiles;
  private boolean reversible;

  private Jpeg2000Validator(byte[] bytes, int columns, int rows) {
    this.bytes = bytes;
    this.columns = columns;
    this.rows = rows;
  }

  /**
   * Returns whether decoding restores every pixel exactly.
   *
   * @throws IOException if the stream is incomplete or is no grey image of this size
   */
  public static boolean isReversible(byte[] bytes, int columns, int rows) throws IOException {
    Jpeg2000Validator stream = new Jpeg2000Validator(bytes, columns, rows);
    int firstTilePart = stream.readMainHeader();
    stream.readTileParts(firstTilePart);
    return stream.reversible;
  }

  /** Reads the main header and returns the offset of the first tile part. */
  private int readMainHeader() throws IOException {
    boolean coded = false;
    require(word(0) == START && word(2) == SIZE, "does not begin with its size");
    int at = 2;
    for (; word(at) != TILE_PART; at += 2 + segmentLength(at)) {
      if (word(at) == SIZE) {
        require(tiles == 0, "has two sizes");
        readSize(at);
      } else if (word(at) == CODING) {
        require(!coded, "declares its coding twice");
        coded = true;
        readCoding(at);
      } else {
        requireReadable(at);
      }
    }
    require(coded, "does not declare its coding");
    return at;
  }

  private void readSize(int at) throws IOException {
    require(
        quad(at + 6) == columns && quad(at + 10) == rows, "has another size than the DICOM header");
    require((quad(at + 14) | quad(at + 18) | quad(at + 30) | quad(at + 34)) == 0, "has an offset");
    require(word(at + 38) == 1 && segmentLength(at) == 41, "has several components");
    require(unsignedByte(at + 41) == 1 && unsignedByte(at + 42) == 1, "is subsampled");
    long across = (columns - 1) / Math.max(1, quad(at + 22)) + 1;
    long down = (rows - 1) / Math.max(1, quad(at + 26)) + 1;
    require(quad(at + 22) > 0 && quad(at + 26) > 0, "has empty tiles");
    require(across * down <= MAX_TILES, "has too many tiles");
    tiles = (int) (across * down);
  }

  private void readCoding(int at) throws IOException {
    int layers = word(at + 6);
    int levels = unsignedByte(at + 9);
    require(
        layers >= 1 && layers <= MAX_LAYERS && levels <= MAX_LEVELS,
        "has too many layers or levels");
    boolean precincts = (unsignedByte(at + 4) & 1) != 0;
    require(
        segmentLength(at) == 12 + (precincts ? levels + 1 : 0),
        "has a coding segment of a wrong length");
    require(
        unsignedByte(at + 10) <= 8
            && unsignedByte(at + 11) <= 8
            && unsignedByte(at + 10) + unsignedByte(at + 11) <= 8,
        "has code blocks of an invalid size");
    for (int level = 0; precincts && level <= levels; level++) {
      int size = unsignedByte(at + 14 + level);
      require(
          (size & 15) >= MIN_PRECINCT_LOG && size >> 4 >= MIN_PRECINCT_LOG,
          "has precincts that are too small");
    }
    long blocks =
        (((long) columns * rows) >> (unsignedByte(at + 10) + unsignedByte(at + 11) + 4))
            + tiles
            + 1;
    require(blocks * layers <= MAX_BLOCK_LAYERS, "has too many layers");
    reversible = unsignedByte(at + 13) == REVERSIBLE;
  }

  /** Refuses markers that override the coding of a component or move packet headers elsewhere. */
  private void requireReadable(int at) throws IOException {
    int marker = word(at);
    require(
        marker != COMPONENT_CODING && marker != PACKED_HEADS && marker != PACKED_TILE_HEADS,
        "uses a coding that is not supported");
  }

  /** Checks that every tile is present, with its parts in order and as many as it declares. */
  private void readTileParts(int first) throws IOException {
    int[] parts = new int[tiles];
    int[] promised = new int[tiles];
    int at = first;
    while (at + 2 <= bytes.length && word(at) == TILE_PART) {
      long length = quad(at + 6);
      int tile = word(at + 4);
      require(segmentLength(at) == 10 && tile < tiles, "has a tile of an invalid number");
      require(unsignedByte(at + 10) == parts[tile]++, "has tile parts out of order");
      int told = unsignedByte(at + 11);
      require(
          promised[tile] == 0 || told == 0 || told == promised[tile],
          "declares two numbers of tile parts");
      promised[tile] = Math.max(promised[tile], told);
      int end = length == 0 ? bytes.length : (int) Math.min(bytes.length, at + length);
      require(length == 0 || length == (long) end - at, "ends inside a tile");
      requireTileData(at + TILE_PART_BYTES, end);
      at = end;
    }
    for (int tile = 0; tile < tiles; tile++) {
      require(
          parts[tile] > 0 && (promised[tile] == 0 || promised[tile] == parts[tile]),
          "is missing a tile");
    }
    require(at >= bytes.length - 2 || word(at) == END, "continues after its tiles");
  }

  /** Checks that the tile's own markers keep the coding and that data follow them. */
  private void requireTileData(int from, int end) throws IOException {
    int at = from;
    while (at + 2 <= end && word(at) != TILE_DATA) {
      require(word(at) != CODING && word(at) != SIZE, "changes its coding inside a tile");
      requireReadable(at);
      at += 2 + segmentLength(at);
    }
    require(at + 2 <= end, "has a tile without data");
    requireCoded(from - TILE_PART_BYTES, at + 2, end);
  }

  /**
   * Checks that only bytes occur which an encoder writes, also before the data, because the library
   * may read into them.
   */
  private void requireCoded(int from, int dataFrom, int end) throws IOException {
    for (int at = from; at + 1 < end; at++) {
      if (bytes[at] != -1) {
        continue;
      }
      int pair = 0xFF00 | (bytes[at + 1] & 0xff);
      boolean marker = pair == PACKET || pair == PACKET_HEAD_END || pair == END;
      require(pair <= MAX_CODED || marker || (at < dataFrom && pair != 0xFFFF), "is damaged");
    }
    require(end == bytes.length || bytes[end - 1] != -1, "is damaged");
  }

  private int segmentLength(int at) throws IOException {
    require(word(at) >= 0xFF4F && word(at + 2) >= 2, "has a damaged marker");
    return word(at + 2);
  }

  private int unsignedByte(int at) throws IOException {
    require(at < bytes.length, "is incomplete");
    return bytes[at] & 0xff;
  }

  private int word(int at) throws IOException {
    return unsignedByte(at) << 8 | unsignedByte(at + 1);
  }

  private long quad(int at) throws IOException {
    return (long) word(at) << 16 | word(at + 2);
  }

  private static void require(boolean holds, String otherwise) throws IOException {
    if (!holds) {
      throw new IOException("the JPEG 2000 stream " + otherwise);
    }
  }
}
