(run with: --machine laser5)
O0001 (C turns the carriage about the focus: at 180 it stands 80 mm farther out)
G01 X740. F6000. (expect moves: line X740)
C-360. (expect alarm LIMIT says X would stand at 820 mm) (expect moves: none)
M30
(finally machine X740 C0)
