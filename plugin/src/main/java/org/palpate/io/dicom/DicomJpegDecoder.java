package org.palpate.io.dicom;

import com.github.jaiimageio.jpeg2000.impl.J2KImageReaderSpi;
import com.twelvemonkeys.imageio.plugins.jpeg.JPEGImageReaderSpi;
import java.awt.image.Raster;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.spi.IIORegistry;
import javax.imageio.spi.ImageReaderSpi;
import javax.imageio.stream.ImageInputStream;
import org.palpate.io.codec.EofLimitedImageStream;
import org.palpate.io.codec.Jpeg2000Validator;
import org.palpate.io.codec.JpegLsDecoder;
import org.palpate.io.format.Luminance;

/**
 * Decodes frames of JPEG: lossless and reversible JPEG 2000 with libraries that restore every
 * pixel, baseline with the JDK, JPEG-LS with {@link JpegLsDecoder}. The size in the stream is
 * checked before anything is decoded.
 */
final class DicomJpegDecoder {
  private static final int JPEG_BASELINE = 0xFFC0;
  private static final int JPEG_LOSSLESS = 0xFFC3;
  private static final int JPEG_SCAN = 0xFFDA;
  private static final int JPEG_END = 0xFFD9;

  /** More than the bits of one pixel. */
  private static final int PADDING_BYTES = 8;

  private DicomJpegDecoder() {}

  /** Decodes one frame into the low bits of {@code stored}; colours become luminance. */
  static void decode(DicomFile dicom, byte[] bytes, int[] stored, int count) throws IOException {
    if (dicom.syntax().coding() == TransferSyntax.Coding.JPEG_LS) {
      JpegLsDecoder.decode(bytes, dicom.columns(), dicom.rows(), stored);
      return;
    }
    Raster raster =
        switch (dicom.syntax().coding()) {
          case JPEG_2000 -> jpeg2000Raster(dicom, bytes);
          case JPEG -> baselineRaster(dicom, bytes);
          default -> jpegRaster(dicom, bytes);
        };
    if (raster.getWidth() != dicom.columns()
        || raster.getHeight() != dicom.rows()
        || raster.getNumBands() != dicom.samples()) {
      throw new IOException("the JPEG stream has another size than the DICOM header");
    }
    raster.getSamples(0, 0, raster.getWidth(), raster.getHeight(), 0, stored);
    if (raster.getNumBands() == 3) {
      toLuminance(raster, stored, count);
    }
  }

  private static void toLuminance(Raster raster, int[] stored, int count) {
    int[] green = new int[count];
    int[] blue = new int[count];
    raster.getSamples(0, 0, raster.getWidth(), raster.getHeight(), 1, green);
    raster.getSamples(0, 0, raster.getWidth(), raster.getHeight(), 2, blue);
    for (int n = 0; n < count; n++) {
      stored[n] = Luminance.of(stored[n], green[n], blue[n]);
    }
  }

  /** Decodes JPEG of 8 bit with the reader of the JDK, in red, green and blue if it has colours. */
  private static Raster baselineRaster(DicomFile dicom, byte[] bytes) throws IOException {
    checkJpeg(dicom, bytes, JPEG_BASELINE);
    Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName("jpeg");
    while (readers.hasNext()) {
      ImageReaderSpi spi = readers.next().getOriginatingProvider();
      if (spi.getClass().getName().startsWith("com.sun.imageio.")) {
        return raster(spi, bytes);
      }
    }
    throw dicom.refusal("this Java has no reader of JPEG", DicomFile.CONVERT);
  }

  private static Raster jpeg2000Raster(DicomFile dicom, byte[] bytes) throws IOException {
    checkJpeg2000(dicom, bytes);
    return raster(new J2KImageReaderSpi(), bytes);
  }

  private static Raster jpegRaster(DicomFile dicom, byte[] bytes) throws IOException {
    checkJpeg(dicom, bytes, JPEG_LOSSLESS);
    try {
      return raster(registeredJpeg(), padded(bytes));
    } catch (IOException e) {
      // a table of few codes may have none for the padding, which is only needed without fill bits
      return raster(registeredJpeg(), bytes);
    }
  }

  /**
   * Returns the stream with zeros before its end marker. The library drops the last pixel if its
   * bits end directly before the marker, and decodes one pixel too many if they do not.
   */
  private static byte[] padded(byte[] bytes) {
    int end = bytes.length - 2;
    while (end >= 0 && ((bytes[end] & 0xff) << 8 | (bytes[end + 1] & 0xff)) != JPEG_END) {
      end--;
    }
    if (end < 0) {
      return bytes;
    }
    byte[] padded = new byte[bytes.length + PADDING_BYTES];
    System.arraycopy(bytes, 0, padded, 0, end);
    System.arraycopy(bytes, end, padded, end + PADDING_BYTES, bytes.length - end);
    return padded;
  }

  /** Returns the provider of TwelveMonkeys, which works only if it is registered. */
  private static ImageReaderSpi registeredJpeg() {
    IIORegistry registry = IIORegistry.getDefaultInstance();
    JPEGImageReaderSpi known = registry.getServiceProviderByClass(JPEGImageReaderSpi.class);
    if (known != null) {
      return known;
    }
    JPEGImageReaderSpi fresh = new JPEGImageReaderSpi();
    registry.registerServiceProvider(fresh, ImageReaderSpi.class);
    return fresh;
  }

  private static Raster raster(ImageReaderSpi spi, byte[] bytes) throws IOException {
    ImageReader reader = spi.createReaderInstance();
    try (ImageInputStream in = new EofLimitedImageStream(bytes)) {
      reader.setInput(in, true, true);
      return reader.canReadRaster() && spi instanceof J2KImageReaderSpi
          ? reader.readRaster(0, null)
          : reader.read(0).getRaster();
    } catch (RuntimeException e) {
      // on damaged data the libraries throw any unchecked exception
      throw new IOException("the JPEG stream is damaged", e);
    } catch (Error e) {
      if (e.getClass() != Error.class) {
        throw e;
      }
      // JJ2000 throws a bare Error for a tile that cannot be read
      throw new IOException("the JPEG stream is damaged", e);
    } finally {
      reader.dispose();
    }
  }

  private static void checkJpeg2000(DicomFile dicom, byte[] bytes) throws IOException {
    if (!Jpeg2000Validator.isReversible(bytes, dicom.columns(), dicom.rows())) {
      throw dicom.refusal(
          "the image is compressed as JPEG 2000 with loss, which cannot be read",
          "convert it with gdcmconv --raw IN OUT (free, from GDCM)");
    }
  }

  private static void checkJpeg(DicomFile dicom, byte[] bytes, int wanted) throws IOException {
    for (int at = 2; at + 4 <= bytes.length; at += 2 + word(bytes, at + 2)) {
      int marker = word(bytes, at);
      if (marker == wanted) {
        requireSize(dicom, word(bytes, at + 7), word(bytes, at + 5));
        return;
      }
      if (marker == JPEG_SCAN) {
        break;
      }
    }
    throw new IOException("the JPEG stream is not " + dicom.syntax().name());
  }

  private static void requireSize(DicomFile dicom, int width, int height) throws IOException {
    if (width != dicom.columns() || height != dicom.rows()) {
      throw new IOException("the JPEG stream has another size than the DICOM header");
    }
  }

  private static int word(byte[] bytes, int at) throws IOException {
    if (at + 2 > bytes.length) {
      throw new IOException("the JPEG stream is incomplete");
    }
    return (bytes[at] & 0xff) << 8 | (bytes[at + 1] & 0xff);
  }
}
