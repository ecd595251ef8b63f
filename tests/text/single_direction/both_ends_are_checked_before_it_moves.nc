(run with: --machine mill3 --param stroke_check=1 --param overrun.X=5)
O1 (G-8: the overrun leaves the travel, its end does not)
G60 X1. (expect moves: rapid X-4; rapid X1)
G53 G00 X-398. (expect moves: rapid X-398)
G60 X-397. (expect alarm OT0501)
M30
