%
O1 (LEX-1: a program behind the closing percent sign does not exist)
M98 P2 (expect alarm PS0076)
M30
%
O2
M99
