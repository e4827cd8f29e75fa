/** The address of the file, as bundlers give it; may be relative to the bundle: `new URL(address, import.meta.url)`. */
declare const address: string;
export default address;
