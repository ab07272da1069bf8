// Says of each box whether it scrolls sideways.
const boxes = document.querySelectorAll(".scroll");
const mark = () => boxes.forEach((box) => box.classList.toggle("scrolls", box.scrollWidth > box.clientWidth + 1));
addEventListener("resize", mark);
document.querySelectorAll("details").forEach((folded) => folded.addEventListener("toggle", mark));
mark();
