document.getElementById("page").textContent = JSON.stringify(JSON.parse(document.getElementById("ljmd-data").textContent), null, 2);
