%O0003(BACKUP OF A CONTROL)
#100=1 (LEX-1: that line is the leader) (expect #100=1)
G90 G0 X1. (expect moves: rapid X1)
M30
%
