JUNK G00 X99.
% LEADER G00 X98. (expect assumed: what stands before this %) (expect assumed: behind this % in its line)
O1 (LEX-1: junk and leader are not part of the program)
G90 G00 X1. (expect moves: rapid X1)
M30
(finally moves: rapid X1)
%
