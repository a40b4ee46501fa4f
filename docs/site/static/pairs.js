// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// The handle of a pair of pictures: as much of the second is shown as lies right of it.
document.addEventListener("DOMContentLoaded", () => {
  for (const pair of document.querySelectorAll(".pair")) {
    const handle = pair.querySelector("input");
    const show = () => pair.style.setProperty("--handle", handle.value + "%");
    handle.addEventListener("input", show);
    show();
  }
});
