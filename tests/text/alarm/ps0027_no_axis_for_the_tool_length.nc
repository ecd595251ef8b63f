(run with: --param length_axis=1 --set #11001=5)
O1 (TLC-4, PS0027: the axis of a type C length offset stands in the block)
G43 H1 (expect alarm PS0027)
M30
