(run with: --machine laser5)
O0001 (the focus may go to 830, tilted by 90 towards +X only to 600)
G01 X830. F6000. (expect moves: line X830)
X600. (expect moves: line X600)
C90. (expect moves: line C90)
A90. (expect moves: line A90)
X600.001 (expect alarm LIMIT says X would stand at 750.001 mm)
M30
(finally machine X600 A90 C90)
