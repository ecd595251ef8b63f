(run with: --machine laser-xtz)
O0001 (the beam is 25 mm farther out than its carriage)
G01 X300. Y200. F6000. (expect moves: line X300 Y200)
X350. (expect alarm LIMIT says X would stand at 378.112887 mm)
M30
(finally machine X300 Y200)
