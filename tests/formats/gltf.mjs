// glTF files, judged by Khronos' validator: no message of any severity.   usage: gltf.mjs GOISHI

import validator from 'gltf-validator';

import { bytesOf, check, finish, goishi } from './judge.mjs';

const headerSize = 20;

/** The two chunks of a .glb file. */
function chunksOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const jsonSize = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(headerSize, headerSize + jsonSize)));
  return { view, json, start: headerSize + jsonSize + 8 };
}

const validated = (bytes) => validator.validateBytes(bytes, { maxIssues: 10 });

async function isClean(bytes) {
  const { numErrors, numWarnings, numInfos, numHints } = (await validated(bytes)).issues;
  return numErrors + numWarnings + numInfos + numHints === 0;
}

const stones = [
  ['--size 33 --bevel 1mm', [0.022, 0.0092, 0.001]],
  ['--size 22 --color black', [0.0223, 0.0069, 0]],
  ['--width 22mm --height 22mm', [0.022, 0.022, 0]],
  ['--width 30cm --height 1mm --bevel 0.5mm --measured', undefined],
];
for (const [stone, dimensions] of stones) {
  for (const method of ['subdivision', 'rings']) {
    for (const level of [0, 3, 6]) {
      const name = `${stone} --method ${method} --level ${level}`;
      const triangles = Number(
        /triangles +(\d+)/.exec(goishi(`mesh ${name} --output stone.glb --stats`))[1]);
      const bytes = bytesOf('stone.glb');
      const report = await validated(bytes);
      check(await isClean(bytes), `${name}: ${JSON.stringify(report.issues.messages)}`);
      check(report.info.totalTriangleCount === triangles, `${name}: as many triangles as told`);
      const { json } = chunksOf(bytes);
      const vertices = report.info.totalVertexCount;
      check(json.accessors[json.meshes[0].primitives[0].indices].componentType === (vertices < 65536 ? 5123 : 5125),
        `${name}: indices of two bytes where they suffice`);
      const { width, height, bevel } = json.nodes[0].extras;
      if (dimensions) {
        check([width, height, bevel].every((length, i) => length === dimensions[i]), `${name}: extras`);
      }
      // The stone is upright: z of its points is y of the scene.
      const [x, y, z, w] = json.nodes[0].rotation;
      const up = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)];
      check(Math.hypot(up[0], up[1] - 1, up[2]) < 1e-15, `${name}: z becomes y`);
      const { max } = json.accessors[json.meshes[0].primitives[0].attributes.POSITION];
      check(max[2] === Math.fround(height / 2), `${name}: as high as the stone`);
    }
  }
}

// The judge notices.
goishi('mesh --size 33 --level 2 --output stone.glb');
const original = bytesOf('stone.glb');
check(await isClean(original), 'the file that is changed');
const { json } = chunksOf(original);
const primitive = json.meshes[0].primitives[0];
const placeOf = (accessor) => json.bufferViews[json.accessors[accessor].bufferView].byteOffset ?? 0;
const changes = {
  'an index beyond the vertices': ({ view, start }) => view.setUint16(start + placeOf(primitive.indices), 60000, true),
  'a normal that is not unit': ({ view, start }) =>
    view.setFloat32(start + placeOf(primitive.attributes.NORMAL), 1.5, true),
  'a point out of the bounds': ({ view, start }) =>
    view.setFloat32(start + placeOf(primitive.attributes.POSITION), 1, true),
  'a length that is not the file\'s': ({ view }) => view.setUint32(8, original.length + 4, true),
};
for (const [what, change] of Object.entries(changes)) {
  const bytes = original.slice();
  change(chunksOf(bytes));
  check(!(await isClean(bytes)), `${what} is noticed`);
}
finish(100);
