(run with: --machine laser5)
O1 (on a linkage travel is a limit of the joint)
G90 G00 A200. (expect alarm LIMIT)
M30
