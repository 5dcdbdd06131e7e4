/**
 * Decodes compressed bytes, and checks compressed streams before a library reads them.
 *
 * <p>Knows no file format and uses nothing of Palpate. One thread an instance. Bytes.
 */
package org.palpate.io.codec;
