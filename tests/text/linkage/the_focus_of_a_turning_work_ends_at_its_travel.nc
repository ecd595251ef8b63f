(run with: --machine laser-xtz)
O0001 (the focus is 5 mm above Z)
G01 Z55. F600. (expect moves: line Z55)
Z55.001 (expect alarm LIMIT says Z would stand at 50.001 mm)
M30
(finally machine Z55)
