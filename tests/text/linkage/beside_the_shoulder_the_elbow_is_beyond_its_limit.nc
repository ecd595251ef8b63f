(run with: --machine arm4)
O0001 (equal links fold onto the shoulder at T1 180; its travel ends at 163.835, 37.1 mm from there)
G01 X100. Y36. F600. (expect moves: line X100 Y36)
X-100. (expect alarm LIMIT says T1 would stand at 164.32)
M30
(finally machine X100 Y36)
