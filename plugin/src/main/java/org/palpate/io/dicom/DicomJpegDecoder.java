package org.palpate.io.dicom;

import com.github.jaiimageio.jpeg2000.impl.J2KImageReaderSpi;
import com.twelvemonkeys.imageio.plugins.jpeg.JPEGImageReaderSpi;
import java.awt.image.Raster;
import java.io.IOException;
import javax.imageio.ImageReader;
import javax.imageio.spi.IIORegistry;
import javax.imageio.spi.ImageReaderSpi;
import javax.imageio.stream.ImageInputStream;
import org.palpate.io.codec.EofLimitedImageStream;
import org.palpate.io.codec.Jpeg2000Validator;

/**
 * Decodes frames of lossless JPEG and reversible JPEG 2000 with libraries that restore every pixel.
 * The size in the stream is checked before a library reads it.
 */
final class DicomJpegDecoder {
  private static final int JPEG_LOSSLESS = 0xFFC3;
  private static final int JPEG_SCAN = 0xFFDA;

  private DicomJpegDecoder() {}

  /** Decodes one frame into the low bits of {@code stored}. */
  static void decode(DicomFile dicom, byte[] bytes, int[] stored, int count) throws IOException {
    boolean jpeg2000 = dicom.syntax().coding() == TransferSyntax.Coding.JPEG_2000;
    if (jpeg2000) {
      checkJpeg2000(dicom, bytes);
    } else {
      checkJpeg(dicom, bytes);
    }
    Raster raster = raster(jpeg2000 ? new J2KImageReaderSpi() : registeredJpeg(), bytes);
    if (raster.getWidth() != dicom.columns()
        || raster.getHeight() != dicom.rows()
        || raster.getNumBands() != 1) {
      throw new IOException("the JPEG stream has another size than the DICOM header");
    }
    raster.getSamples(0, 0, raster.getWidth(), raster.getHeight(), 0, stored);
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

  private static void checkJpeg(DicomFile dicom, byte[] bytes) throws IOException {
    for (int at = 2; at + 4 <= bytes.length; at += 2 + word(bytes, at + 2)) {
      int marker = word(bytes, at);
      if (marker == JPEG_LOSSLESS) {
        requireSize(dicom, word(bytes, at + 7), word(bytes, at + 5));
        return;
      }
      if (marker == JPEG_SCAN) {
        break;
      }
    }
    throw new IOException("the JPEG stream is not lossless");
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
