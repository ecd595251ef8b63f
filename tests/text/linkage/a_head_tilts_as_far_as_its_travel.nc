(run with: --machine laser5)
O0001 (A is a word of the program and a joint)
G01 A180. F6000. (expect moves: line A180)
A181. (expect alarm LIMIT says A would stand at 181 degrees)
M30
(finally machine A180)
