n=0
for c0=1 to 1
for c1=1 to 1
for c2=1 to 1
for c3=1 to 1
for c4=1 to 1
for c5=1 to 1
for c6=1 to 1
for c7=1 to 1
for c8=1 to 1
for c9=1 to 1
for c10=1 to 1
for c11=1 to 1
for c12=1 to 1
for c13=1 to 1
for c14=1 to 1
for c15=1 to 1
for c16=1 to 1
for c17=1 to 1
for c18=1 to 1
for c19=1 to 1
for c20=1 to 1
for c21=1 to 1
for c22=1 to 1
for c23=1 to 1
for c24=1 to 1
for c25=1 to 1
for c26=1 to 1
for c27=1 to 1
for c28=1 to 1
for c29=1 to 1
for c30=1 to 1
for c31=1 to 1
for c32=1 to 1
for c33=1 to 1
for c34=1 to 1
for c35=1 to 1
for c36=1 to 1
for c37=1 to 1
for c38=1 to 1
for c39=1 to 1
for c40=1 to 1
for c41=1 to 1
for c42=1 to 1
for c43=1 to 1
for c44=1 to 1
for c45=1 to 1
for c46=1 to 1
for c47=1 to 1
for c48=1 to 1
for c49=1 to 1
for c50=1 to 1
for c51=1 to 1
for c52=1 to 1
for c53=1 to 1
for c54=1 to 1
for c55=1 to 1
for c56=1 to 1
for c57=1 to 1
for c58=1 to 1
for c59=1 to 1
for c60=1 to 1
for c61=1 to 1
for c62=1 to 1
for c63=1 to 1
for c64=1 to 1
for c65=1 to 1
for c66=1 to 1
for c67=1 to 1
for c68=1 to 1
for c69=1 to 1
for c70=1 to 1
for c71=1 to 1
for c72=1 to 1
for c73=1 to 1
for c74=1 to 1
for c75=1 to 1
for c76=1 to 1
for c77=1 to 1
for c78=1 to 1
for c79=1 to 1
for c80=1 to 1
for c81=1 to 1
for c82=1 to 1
for c83=1 to 1
for c84=1 to 1
for c85=1 to 1
for c86=1 to 1
for c87=1 to 1
for c88=1 to 1
for c89=1 to 1
for c90=1 to 1
for c91=1 to 1
for c92=1 to 1
for c93=1 to 1
for c94=1 to 1
for c95=1 to 1
for c96=1 to 1
for c97=1 to 1
for c98=1 to 1
for c99=1 to 1
n=n+1
next c99
next c98
next c97
next c96
next c95
next c94
next c93
next c92
next c91
next c90
next c89
next c88
next c87
next c86
next c85
next c84
next c83
next c82
next c81
next c80
next c79
next c78
next c77
next c76
next c75
next c74
next c73
next c72
next c71
next c70
next c69
next c68
next c67
next c66
next c65
next c64
next c63
next c62
next c61
next c60
next c59
next c58
next c57
next c56
next c55
next c54
next c53
next c52
next c51
next c50
next c49
next c48
next c47
next c46
next c45
next c44
next c43
next c42
next c41
next c40
next c39
next c38
next c37
next c36
next c35
next c34
next c33
next c32
next c31
next c30
next c29
next c28
next c27
next c26
next c25
next c24
next c23
next c22
next c21
next c20
next c19
next c18
next c17
next c16
next c15
next c14
next c13
next c12
next c11
next c10
next c9
next c8
next c7
next c6
next c5
next c4
next c3
next c2
next c1
next c0
print n;c0;c99 ' (expect n=1, c0=2, c99=2)
