(run with: --machine laser5 --param LRP=0)
O0001 (X is there first, at 740; the turn of C alone then needs a carriage beyond 750)
G01 X560. F6000.
G00 X740. C360. (expect alarm LIMIT says X would stand at 81) (expect moves: none)
M30
(finally machine X560 C0)
