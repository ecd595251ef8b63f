(run with: --machine laser5 --param LRP=1)
O0001 (half the turn is done at 650, where the carriage stands at 730)
G01 X560. F6000.
G00 X740. C360. (expect moves: rapid X740 C360)
M30
(finally machine X740 C360)
