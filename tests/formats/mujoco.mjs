// Bodies, read by MuJoCo: our mass and our moments to the last bit.   usage: mujoco.mjs GOISHI

import load from '@mujoco/mujoco';

import { bytesOf, changed, check, finish, goishi, textOf } from './judge.mjs';

const mujoco = await load();

let folders = 0;

/** What MuJoCo makes of a text and of the mesh beside it: the body's mass, moments and attitude; else why not. */
function read(text) {
  const folder = `/${++folders}`;  // it keeps what it has read of a path
  mujoco.FS.mkdir(folder);
  mujoco.FS.writeFile(`${folder}/stone.obj`, bytesOf('stone.obj'));
  mujoco.FS.writeFile(`${folder}/stone.xml`, text);
  let model;
  try {
    model = mujoco.MjModel.from_xml_path(`${folder}/stone.xml`);
    const body = model.nbody - 1;
    return {
      bodies: model.nbody,
      mass: model.body_mass[body],
      moments: [...model.body_inertia.slice(3 * body, 3 * body + 3)],
      place: [...model.body_ipos.slice(3 * body, 3 * body + 3)],
      attitude: [...model.body_iquat.slice(4 * body, 4 * body + 4)],
      points: model.mesh_vertnum[0],
      triangles: model.mesh_facenum[0],
    };
  } catch (error) {
    return { why: error.message };
  } finally {
    model?.delete();
  }
}

/** The tensor in the body's frame: R diag(moments) Rᵀ. */
function tensorOf({ moments, attitude: [w, x, y, z] }) {
  const rows = [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
  return rows.map((a) => rows.map((b) => moments.reduce((sum, moment, k) => sum + a[k] * moment * b[k], 0)));
}

/** Whether what was read is the stone. MuJoCo turns a URDF's tensor to its axes, and writes its attitude with an error of
    some 1e-15. */
function isStone(found, stone, turned) {
  const expected = [stone.transverse, stone.transverse, stone.axial];
  const tensor = found.moments && tensorOf(found);
  const sorted = (list) => [...list].sort((a, b) => a - b);
  return (
    found.why === undefined && found.bodies === 2 && found.mass === stone.mass && found.place.every((c) => c === 0) &&
    (turned ? sorted(found.moments).every((moment, i) => moment === sorted(expected)[i])
      : found.moments.every((moment, i) => moment === expected[i]) &&
        found.attitude.every((c, i) => c === [1, 0, 0, 0][i])) &&
    tensor.every((row, i) =>
      row.every((entry, j) => Math.abs(entry - (i === j ? expected[i] : 0)) <= (turned ? 1e-14 : 0) * stone.axial))
  );
}

// What says the shape, and what says the mass.
const stones = [
  ['--size 33 --bevel 1mm', ''],
  ['--size 22 --color black', ' --mass 4.321g'],
  ['--width 22mm --height 22mm', ' --density 1.7g/cm3'],
  ['--width 30cm --height 1mm --bevel 0.5mm --measured', ''],
];
for (const [shape, mass] of stones) {
  const words = shape + mass;
  const stone = JSON.parse(goishi(`inertia ${words} --format json`));
  const counts = goishi(`mesh ${shape} --level 2 --stats`);
  for (const format of ['mjcf', 'urdf']) {
    goishi(`body ${words} --level 2 --format ${format} --output stone.${format}`);
    const found = read(textOf(`stone.${format}`));
    check(isStone(found, stone, format === 'urdf'), `${words} as ${format}: ${JSON.stringify(found)}`);
    check(found.triangles === Number(/triangles +(\d+)/.exec(counts)[1]), `${words} as ${format}: triangles`);
    check(found.points === Number(/\npoints +(\d+)/.exec(counts)[1]), `${words} as ${format}: points`);
  }
}

// The judge notices.
const stone = JSON.parse(goishi('inertia --size 33 --format json'));
goishi('body --size 33 --level 2 --output stone.urdf');
goishi('body --size 33 --level 2 --output stone.mjcf');
const mass = /mass="([^"]*)"/.exec(textOf('stone.mjcf'))[1];
const axial = /izz="([^"]*)"/.exec(textOf('stone.urdf'))[1];
const next = (digits) => {
  const moved = Number(digits) * (1 + 2 ** -52);
  check(moved !== Number(digits), 'the change of a number changes it');
  return String(moved);
};
const changes = [
  ['stone.mjcf', `mass="${mass}"`, `mass="-${mass}"`],
  ['stone.mjcf', `mass="${mass}"`, `mass="${next(mass)}"`],
  ['stone.mjcf', `${axial}"`, `${Number(axial) * 3}"`],
  ['stone.mjcf', ` ${axial}"`, ` ${next(axial)}"`],
  ['stone.mjcf', 'pos="0 0 0"', 'pos="0 0 1e-9"'],
  ['stone.mjcf', 'stone.obj', 'other.obj'],
  ['stone.urdf', `value="${mass}"`, `value="-${mass}"`],
  ['stone.urdf', `value="${mass}"`, `value="${next(mass)}"`],
  ['stone.urdf', `izz="${axial}"`, ''],
  ['stone.urdf', `izz="${axial}"`, `izz="${Number(axial) * 3}"`],
  ['stone.urdf', `izz="${axial}"`, `izz="${next(axial)}"`],
  ['stone.urdf', 'ixy="0"', `ixy="${Number(axial) / 100}"`],
  ['stone.urdf', 'fusestatic="false"', 'fusestatic="true"'],
];
for (const [file, from, to] of changes) {
  const text = textOf(file);
  check(isStone(read(text), stone, file === 'stone.urdf'), `${file}, which is changed`);
  check(!isStone(read(changed(text, from, to)), stone, file === 'stone.urdf'), `${file} with ${to} for ${from} is noticed`);
}
finish(60);
