(run with: --machine arm4)
O0001 (the contour ends 262.3 mm from the shoulder, the tool goes 10 mm beside it)
G10 L12 P1 R10.
G01 X150. Y100. F600.
G41 D1 X180. Y185.
X185. Y186. (expect alarm OUT_OF_REACH at X185. Y186.)
X200. Y100.
G40 X150. Y100.
M30
