a=7
b=3
print a+b;a-b;a*b;a/b
print a%b, -2^2, 2^3^2
print (a>b)+(a<b)*10+(a==7)
print int(-2.5); abs(-3); sqr(16); sgn(-9)
' (finally prints 10 4 21 2.333333333)
' (finally prints 1       -4      512)
' (finally prints 2)
' (finally prints -3 3 4 -1)
